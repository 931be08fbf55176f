#include "orchestrator/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "mill/base/failure.h"
#include "orchestrator/pictures/plots.h"
#include "orchestrator/results/measured_charge.h"
#include "tests/support/synthetic_campaign.h"

namespace millwear::orchestrator {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pointwise;

const PageLibraries no_drawing{.d3 = {.script = "/* d3 */", .licence = "licence <of> d3"},
                               .pako = {.script = "/* pako */", .licence = "licence of pako"}};

nlohmann::json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const auto from = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

std::string without_scripts(std::string page) {
  for (auto from = page.find("<script"); from != std::string::npos; from = page.find("<script"))
    page.erase(from, page.find("</script>", from) + 9 - from);
  return page;
}

// Classes 2 and 4 of five: one of them empty between.
TEST(Report, KeepsRatesFromTheFirstClassWithAnyToTheLast) {
  auto campaign = synthetic_campaign(1, 1);
  campaign.impacts[0].liner[0].normal = {0.0, 0.0, 1.23456, 0.0, 2.0, 0.0};
  campaign.impacts[0].liner[0].shear = {0.0, 0.0};
  const auto line = data_of(report_html(campaign, no_drawing))["impacts"][0]["liner"][0];
  EXPECT_EQ(line["normal"]["first"], 2);
  EXPECT_EQ(line["normal"]["rates"], (std::vector<double>{1.235, 0.0, 2.0}));
  EXPECT_TRUE(line["shear"]["rates"].empty());
}

std::vector<double> numbers_of(const nlohmann::json& array) {
  return array.get<std::vector<double>>();
}

/// The long arrays of the page have eight digits.
MATCHER(EqualTo8Digits, "") {
  const auto& [shown, value] = arg;
  return std::abs(shown - value) <= 5.1e-8 * std::abs(value);
}

TEST(Report, HoldsEveryFigureOfTheCampaign) {
  const auto campaign = synthetic_campaign(3, 2);
  const auto json = data_of(report_html(campaign, no_drawing));
  EXPECT_EQ(json["case_name"], campaign.case_name);
  EXPECT_EQ(json["life"]["hours"], campaign.life.hours);
  EXPECT_EQ(json["sector"]["rows"], 52);
  ASSERT_EQ(json["history"].size(), campaign.history.size());
  EXPECT_EQ(json["history"].back()["lifter_height"], campaign.history.back().lifter_height);
  ASSERT_EQ(json["profiles"].size(), campaign.profiles.size());
  for (std::size_t i = 0; i < campaign.profiles.size(); ++i) {
    const auto& nodes = campaign.profiles[i].nodes;
    ASSERT_EQ(json["profiles"][i]["nodes"].size(), nodes.size());
    EXPECT_NEAR(json["profiles"][i]["nodes"][5][1], nodes[5].y(), 1e-8);
  }
  ASSERT_EQ(json["loads"].size(), 3u);
  EXPECT_THAT(numbers_of(json["loads"][2]["contacts"]["raw"]),
              Pointwise(EqualTo8Digits(), campaign.loads[2].contacts.raw));
  EXPECT_THAT(numbers_of(json["loads"][2]["depth_rate"]["smoothed"]),
              Pointwise(EqualTo8Digits(), campaign.loads[2].depth_rate.smoothed));
  ASSERT_EQ(json["impacts"].size(), 3u);
  EXPECT_EQ(json["impacts"][0]["liner"].size(), 13u);
  EXPECT_EQ(json["impacts"][0]["particles"][2]["name"], "ore on ore");
  EXPECT_EQ(json["impacts"][1]["particles"].size(), 0u);
  EXPECT_EQ(json["energy_edges"].size(), 141u);
  EXPECT_EQ(json["power"][1]["power"], campaign.power[1].power);
  EXPECT_EQ(json["conservation"].size(), 3u);
  ASSERT_EQ(json["motion"].size(), 3u);
  EXPECT_EQ(json["motion"][2]["airborne_share"]["value"],
            campaign.motion[2].measures.airborne_share.value);
  EXPECT_EQ(json["motion"][2]["hit_power"], campaign.motion[2].hit_power);
  EXPECT_EQ(json["warnings"], campaign.warnings);
  EXPECT_EQ(json["provenance"][0][1], campaign.provenance[0].value);
}

TEST(Report, WritesAnUnknownFigureAsNull) {
  auto campaign = synthetic_campaign(1, 1);
  campaign.history[0].tonnes = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(data_of(report_html(campaign, no_drawing))["history"][0]["tonnes"].is_null());
}

TEST(Report, TreatsNamesAsTextWhateverTheyHold) {
  auto campaign = synthetic_campaign(1, 1);
  const std::string name = "</script><script>alert(1)</script> {{data}} & \"co\" \xff";
  campaign.case_name = name;
  campaign.warnings = {"<img src=x onerror=alert(2)>"};
  const auto page = report_html(campaign, no_drawing);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt; "
                              "{{data}} &amp; &quot;co&quot;"));
  EXPECT_THAT(page, HasSubstr("licence &lt;of&gt; d3"));
  EXPECT_THAT(data_of(page)["case_name"].get<std::string>(), HasSubstr("</script><script>"));
  EXPECT_EQ(data_of(page)["warnings"][0], campaign.warnings[0]);
}

TEST(Report, LoadsNothingFromAnywhere) {
  const auto page = report_html(synthetic_campaign(1, 1));
  EXPECT_THAT(page, HasSubstr("content=\"default-src 'none';"));
  const auto markup = without_scripts(page);
  EXPECT_THAT(markup, HasSubstr("</html>"));
  for (const auto* reference : {"src=", "@import", "url(", "<link", "<iframe", "href=\"http"})
    EXPECT_THAT(markup, Not(HasSubstr(reference)));
}

TEST(Report, NamesThePackageWhereD3IsMissing) {
  try {
    (void)installed_d3(std::filesystem::path(::testing::TempDir()) / "nothing here");
    ADD_FAILURE() << "d3 was found in an empty folder";
  } catch (const ExternalProgramError& error) {
    EXPECT_THAT(error.what(), HasSubstr("libjs-d3"));
  }
}

TEST(Report, IsTheSameForTheSameCampaign) {
  EXPECT_EQ(report_html(synthetic_campaign(2, 2)), report_html(synthetic_campaign(2, 2)));
}

// Cycle 1 is measured on the last profile of cycle 0, at 200 h; a row of step 0 is that profile
// itself.
TEST(MeasuredCharge, StandsAtTheAgeOfTheLinerItRanOn) {
  const auto row = [](int cycle, int step, double hours, double power) {
    HistoryRow made{};
    made.cycle = cycle;
    made.step = step;
    made.operating_hours = hours;
    made.power = power;
    return made;
  };
  const auto charges =
      measured_charges({row(0, 0, 0.0, 10.0), row(0, 1, 100.0, 10.0), row(0, 2, 200.0, 10.0),
                        row(1, 1, 300.0, 12.0), row(2, 0, 400.0, 13.0)});
  ASSERT_EQ(charges.size(), 3u);
  EXPECT_EQ(charges[0].operating_hours, 0.0);
  EXPECT_EQ(charges[1].operating_hours, 200.0);
  EXPECT_EQ(charges[1].power, 12.0);
  EXPECT_EQ(charges[2].operating_hours, 400.0);
}

class Plots : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(Plots, ArePngFiles) {
  write_plots(synthetic_campaign(2, 2), folder);
  for (const auto* name : {"profiles.png", "history.png"}) {
    std::ifstream file(folder / name, std::ios::binary);
    std::string start(8, '\0');
    file.read(start.data(), 8);
    EXPECT_EQ(start, "\x89PNG\r\n\x1a\n") << name;
    EXPECT_GT(std::filesystem::file_size(folder / name), 5000u) << name;
  }
}

TEST_F(Plots, NameThePackageWhereGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.c_str(), 1);
  try {
    write_plots(synthetic_campaign(1, 1), folder);
    ADD_FAILURE() << "gnuplot was found in an empty folder";
  } catch (const ExternalProgramError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot-nox"));
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace millwear::orchestrator
