#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>
#include <string>

#include "orchestrator/report/report.h"
#include "tests/needs_chromium/browser.h"
#include "tests/support/synthetic_campaign.h"

namespace millwear::orchestrator {
namespace {

/// The page with a script that runs after its own.
std::string with_script(std::string page, const std::string& script) {
  page.insert(page.rfind("</body>"), "<script>" + script + "</script>");
  return page;
}

class ReportPage : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder); }

  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("report_page_" + std::to_string(::getpid()));
};

// 3 cycles of 2 steps and the new liner: 7 profiles and 7 rows; 120 bins.
TEST_F(ReportPage, DrawsEveryProfileBinAndRow) {
  const auto page = drawn(report_html(synthetic_campaign(3, 2)), folder);
  const auto over_time = part_between(page, "id=\"profiles-over-time\"", "<figcaption");
  EXPECT_EQ(count_of(over_time, "class=\"profile"), 7u);
  EXPECT_EQ(count_of(part_between(page, "id=\"bins-drawing\"", "<figcaption"), "<circle"), 120u);
  EXPECT_EQ(count_of(part_between(page, "id=\"history-table\"", "</section>"), "<tr"), 8u);
  EXPECT_NE(page.find("max=\"2\""), std::string::npos);
  EXPECT_EQ(count_of(page, "NaN"), count_of(report_html(synthetic_campaign(3, 2)), "NaN"));
}

// Cycle 0 has 13 classes on the liner and three pairs of materials, each chart a line for them all.
TEST_F(ReportPage, DrawsImpactsByClassAndByPairOfMaterials) {
  const auto page = drawn(report_html(synthetic_campaign(3, 2)), folder);
  const auto lines = [&](const std::string& chart) {
    return count_of(part_between(page, "id=\"" + chart + "\"", "</svg>"), "class=\"series");
  };
  EXPECT_EQ(lines("liner-normal-chart"), 14u);
  EXPECT_EQ(lines("liner-shear-chart"), 14u);
  EXPECT_EQ(lines("particles-normal-chart"), 4u);
  EXPECT_EQ(lines("particles-shear-chart"), 4u);
  EXPECT_EQ(count_of(part_between(page, "id=\"impacts-table\"", "</section>"), "<tr"), 17u);
}

TEST_F(ReportPage, DrawsMeasuredProfilesBesideThePredicted) {
  auto campaign = synthetic_campaign(3, 2);
  campaign.measured_profiles = {{5112, campaign.profiles.at(2).nodes},
                                {6312, campaign.profiles.at(4).nodes}};
  campaign.measured.at(1).error = 0.002;
  const auto page = drawn(report_html(campaign), folder);
  const auto over_time = part_between(page, "id=\"profiles-over-time\"", "</svg>");
  EXPECT_EQ(count_of(over_time, "class=\"gauge\""), 2u);
  EXPECT_EQ(count_of(over_time, "measured at"), 2u);
  // One bar of a reading, and one of every predicted height.
  const auto height = part_between(page, "id=\"height-chart\"", "</svg>");
  EXPECT_EQ(count_of(part_between(height, "class=\"error\"", "</path>"), "M"),
            campaign.history.size());
  EXPECT_EQ(
      count_of(part_between(height.substr(height.rfind("class=\"error\"")), "class", "</path>"),
               "M"),
      1u);
}

// Three predicted moments with a band, the line, and readings that are held out or not.
TEST_F(ReportPage, DrawsTheCalibratedPredictionWhereThereIsOne) {
  auto campaign = synthetic_campaign(3, 2);
  EXPECT_NE(drawn(report_html(campaign), folder).find("not calibrated on its readings"),
            std::string::npos);
  CalibratedCourse course{};
  course.until = 5112.0;
  course.factor = {0.9, {0.85, 0.95}};
  course.fresh_height = 0.215;
  course.line_rate = 2.5e-5;
  course.curve = {{0.0, {0.215, {0.215, 0.215}}},
                  {5112.0, {0.088 - 1e-12, {0.084, 0.092}}},
                  {7000.0, {0.032, {0.026, 0.038}}}};
  course.readings = {
      {5112.0, CourseUse::calibrated, 0.088, 0.002, course.curve[1].height, 0.0872, {}, {}},
      {7152.0, CourseUse::held_out, 0.030, 0.002, {}, 0.0362, {}, {}}};
  course.verdict = "Nothing to judge by.";
  course.remarks = {"1 reading is after the last liner"};
  campaign.calibrated = course;
  const auto page = drawn(report_html(campaign), folder);
  const auto chart = part_between(page, "id=\"calibrated-chart\"", "</svg>");
  EXPECT_EQ(count_of(chart, "class=\"series"), 2u);
  EXPECT_EQ(count_of(chart, "fill: var(--band-fill)"), 1u);
  EXPECT_EQ(count_of(chart, "<circle"), 2u);
  const auto table = part_between(page, "id=\"calibrated-table\"", "</section>");
  EXPECT_EQ(count_of(table, "<tr"), 3u);
  EXPECT_NE(table.find("84.0 to 92.0"), std::string::npos);
  EXPECT_EQ(table.find("−0.0"), std::string::npos);
  EXPECT_NE(table.find("1 reading is after the last liner"), std::string::npos);
  EXPECT_NE(page.find("Nothing to judge by."), std::string::npos);
}

// First cycle, which is the chosen one, against last, in twelve rows; three lines of shares, and
// hits new and worn.
TEST_F(ReportPage, HoldsTheChargeOnTheNewLinerAgainstTheWorn) {
  const auto page = drawn(report_html(synthetic_campaign(3, 2)), folder);
  const auto table = part_between(page, "id=\"motion-table\"", "</section>");
  EXPECT_EQ(count_of(table, "<tr"), 13u);
  EXPECT_EQ(count_of(table, "scope=\"col\""), 4u);
  EXPECT_NE(table.find("Cycle 0"), std::string::npos);
  EXPECT_NE(table.find("Cycle 2"), std::string::npos);
  const auto lines = [&](const std::string& chart) {
    return count_of(part_between(page, "id=\"" + chart + "\"", "</svg>"), "class=\"series");
  };
  EXPECT_EQ(lines("motion-chart"), 3u);
  EXPECT_EQ(lines("hit-power-chart"), 1u);
  EXPECT_EQ(lines("hits-around-chart"), 2u);
}

// With the dumps nothing is known of the motion: what is left of the table is toe, shoulder, power.
TEST_F(ReportPage, LeavesOutTheMotionThatWasNotRecorded) {
  auto campaign = synthetic_campaign(3, 2);
  for (auto& motion : campaign.motion) motion = {motion.cycle, wear::unknown_motion(), {}};
  const auto page = drawn(report_html(campaign), folder);
  EXPECT_EQ(count_of(part_between(page, "id=\"motion-table\"", "</section>"), "<tr"), 4u);
  EXPECT_NE(part_between(page, "id=\"hits-around-chart\"", "</figure>").find("Not recorded"),
            std::string::npos);
  EXPECT_NE(part_between(page, "id=\"motion-chart\"", "</figure>").find("Not recorded"),
            std::string::npos);
}

// All panels are drawn, then the slider moves as a reader would move it; every panel tells of the
// third of three cycles.
TEST_F(ReportPage, MovesEveryPanelWithTheSlider) {
  const auto campaign = synthetic_campaign(3, 2);
  const auto page =
      drawn(with_script(report_html(campaign),
                        "drawAllPanels();"
                        "const slider = document.getElementById('cycle-slider'); slider.value = 2;"
                        "slider.dispatchEvent(new Event('input'));"),
            folder);
  const HistoryRow& liner = campaign.history.at(4);
  ASSERT_EQ(liner.cycle, 1);
  const auto has = [&](const std::string& from, const std::string& to, const std::string& part) {
    return part_between(page, from, to).find(part) != std::string::npos;
  };
  EXPECT_TRUE(has("id=\"cycle-words\"", "</output>", "Cycle 2 (3 of 3): 4,867 h"));
  EXPECT_TRUE(has("id=\"liner-table\"", "</table>", "Cycle 2"));
  EXPECT_TRUE(has("id=\"liner-table\"", "</table>",
                  fmt::format("<td class=\"\">{:.1f}</td>", 1e3 * liner.lifter_height)));
  EXPECT_TRUE(has("id=\"landmarks-table\"", "</table>",
                  fmt::format(">{:.1f}<", 180.0 / std::numbers::pi *
                                              campaign.charge.cycles.at(2).landmarks.shoulder)));
  EXPECT_TRUE(has("id=\"section-map\"", "</svg>", "Occupancy over the section, cycle 2"));
  EXPECT_TRUE(has("id=\"around-map\"", "</svg>", "Contacts around the turn, cycle 2"));
  EXPECT_TRUE(has("id=\"impacts-table\"", "</table>", "Collisions in cycle 2"));
  EXPECT_TRUE(has("id=\"motion-table\"", "</table>", "Cycle 2"));
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
  const auto first = drawn(report_html(campaign), folder);
  for (const std::string panel :
       {"profiles-over-time", "bins-drawing", "height-chart", "contacts-chart",
        "normal-dissipation-chart", "sliding-work-chart", "depth-rate-chart", "load-drawing",
        "power-series-chart", "liner-normal-chart", "liner-shear-chart"}) {
    const auto drawing = [&](const std::string& of) {
      return part_between(of, "id=\"" + panel + "\"", "</svg>");
    };
    EXPECT_TRUE(drawing(page) != drawing(first)) << panel;
  }
}

// The bytes of a map give its values back: 0 to 1 for the share that is occupied, 0.6 in the bed.
TEST_F(ReportPage, ReadsTheMapsOfTheCharge) {
  const auto campaign = synthetic_campaign(1, 1);
  const auto page = drawn(with_script(report_html(campaign),
                                      "const read = valuesOf(data.charge.cycles[0].maps.occupied);"
                                      "const told = [...read].filter((value) => value === value);"
                                      "document.title = `${told.length} cells from "
                                      "${d3.min(told).toFixed(2)} to ${d3.max(told).toFixed(2)}`;"),
                          folder);
  const auto& occupied = map_named(campaign.charge.cycles.at(0), "occupied").values;
  EXPECT_NE(page.find(fmt::format("<title>{} cells from 0.60 to 0.60</title>",
                                  occupied.array().isFinite().count())),
            std::string::npos);
}

// 37.5 degrees behind six o'clock is the eighth column of the page, and the 44th from twelve
// o'clock. 255 equal ratios from 0.1 to the most, some 16, are 2 % each.
TEST_F(ReportPage, ReadsTheLoadAroundTheTurnOverItsMean) {
  const auto campaign = synthetic_campaign(1, 1);
  const auto page =
      drawn(with_script(report_html(campaign),
                        "const read = valuesOf(data.charge.cycles[0].around.maps.contacts);"
                        "document.title = `value ${read[7 + 72 * 71]}, ${read[43 + 72 * 71]}`;"),
            folder);
  const Eigen::MatrixXd& contacts = campaign.polar.at(0).load.values[0];
  const std::string found = part_between(page, "<title>value ", "</title>");
  EXPECT_NEAR(std::stod(found.substr(13)) / (contacts(71, 43) / contacts.mean()), 1.0, 0.02);
  EXPECT_EQ(found.substr(found.find(", ") + 2), "NaN") << "less than a tenth of the mean is there";
}

TEST_F(ReportPage, SaysWhichCycleHasNoRecordOfTheCharge) {
  auto campaign = synthetic_campaign(3, 2);
  campaign.charge.cycles.erase(campaign.charge.cycles.begin());
  EXPECT_NE(drawn(report_html(campaign), folder).find("Cycle 0 has no charge.h5"),
            std::string::npos);
  campaign.charge.cycles.clear();
  const auto page = drawn(report_html(campaign), folder);
  EXPECT_NE(page.find("This campaign has no charge.h5"), std::string::npos);
  EXPECT_EQ(page.find("id=\"section-map\""), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

// 215 mm are 8.465 in; three o'clock is 90 degrees before twelve; 7300 h at half the time are 14600
// h or 608 days after 1 January 2026.
TEST_F(ReportPage, KeepsTheSettingsInItsAddress) {
  const auto campaign = synthetic_campaign(3, 2);
  const auto page =
      drawn(report_html(campaign), folder,
            "#units=inch&angles=twelve&start=2026-01-01&running=50&axis=dates&cycle=1");
  EXPECT_NE(part_between(page, "id=\"liner-table\"", "</table>").find(">8.465<"),
            std::string::npos);
  EXPECT_NE(part_between(page, "id=\"landmarks-table\"", "</table>")
                .find(fmt::format(">{:.1f}<",
                                  270.0 + 180.0 / std::numbers::pi *
                                              campaign.charge.cycles.at(1).landmarks.shoulder)),
            std::string::npos);
  EXPECT_NE(page.find("on 1 Sep 2027"), std::string::npos);
  EXPECT_NE(part_between(page, "id=\"cycle-words\"", "</output>").find("Cycle 1"),
            std::string::npos);
  EXPECT_NE(part_between(page, "id=\"height-chart\"", "</svg>").find(">date<"), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

// Faster from the second cycle on, after ten days at rest: the charts appear, and the life's date
// is ten days later than without.
TEST_F(ReportPage, ShowsAnOperationThatChanges) {
  auto campaign = synthetic_campaign(3, 2);
  const std::string start = "#start=2026-01-01&axis=dates";
  const auto operation = [](const std::string& page) {
    return part_between(page, "id=\"operation\"", "Where these hits land");
  };
  const auto constant = drawn(report_html(campaign), folder, start);
  EXPECT_NE(operation(constant).find("hidden"), std::string::npos);
  EXPECT_NE(constant.find("on 1 Nov 2026"), std::string::npos);
  for (auto& row : campaign.history) {
    if (row.cycle == 0) continue;
    row.speed = 12.16;
    row.calendar_hours += 240.0;
  }
  const auto page = drawn(with_script(report_html(campaign), "drawAllPanels();"), folder, start);
  EXPECT_EQ(operation(page).find("hidden"), std::string::npos);
  EXPECT_EQ(count_of(operation(page), "class=\"series"), 2u);
  EXPECT_NE(page.find("on 11 Nov 2026"), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

// A section of the worn liner, 52 lifters, 7800 kg/m3 and 1.679 Mt milled.
TEST_F(ReportPage, SaysTheSteelWornForATonne) {
  const auto campaign = synthetic_campaign(3, 2);
  const double grams =
      52 * campaign.history.back().worn_volume * 7800.0 * 1e3 / campaign.life.tonnes;
  const auto answer = [&](const std::string& fragment) {
    return part_between(drawn(report_html(campaign), folder, fragment), "id=\"answer\"",
                        "</div></section>");
  };
  EXPECT_NE(answer("").find(fmt::format("Steel worn: {:.1f} g/t for each metre", grams)),
            std::string::npos);
  EXPECT_NE(answer("#length=3").find(fmt::format("Steel worn: {:.1f} g/t milled", 3.0 * grams)),
            std::string::npos);
}

// A campaign before its first result: the page still says what it is and draws nothing.
TEST_F(ReportPage, OfAnEmptyCampaignSaysSo) {
  auto campaign = synthetic_campaign(0, 1);
  campaign.measured.clear();
  const auto page = drawn(report_html(campaign), folder);
  EXPECT_NE(page.find("No profile was published yet."), std::string::npos);
  EXPECT_NE(page.find("The liner has not been worn yet."), std::string::npos);
  EXPECT_EQ(count_of(part_between(page, "<main>", "</main>"), "<svg"), 0u);
}

}  // namespace
}  // namespace millwear::orchestrator
