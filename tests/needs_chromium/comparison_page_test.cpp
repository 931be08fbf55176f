#include "orchestrator/comparison/comparison_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>

#include "orchestrator/results/measured_charge.h"
#include "tests/needs_chromium/browser.h"
#include "tests/support/example_case.h"
#include "tests/support/synthetic_campaign.h"

namespace millwear::orchestrator {
namespace {

class ComparisonPage : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder); }

  static ComparedCampaign compared(const std::string& name, CampaignResults data) {
    const Case mill = example_case();
    data.charge.slice_length = mill.slice_length;
    return {name, {mill, {"nowhere"}, 1}, std::move(data), {}};
  }

  /// A worn-out campaign of three cycles, and one of two that is not worn out, without charge.
  static Comparison new_and_unfinished() {
    auto unfinished = synthetic_campaign(2, 2);
    unfinished.life.reached = false;
    unfinished.charge.cycles.clear();
    unfinished.loads.clear();
    auto other = compared("unfinished", std::move(unfinished));
    other.campaign.mill.dem.seed = 9;
    other.missing = {"maps: 2 of 2 cycles have no dem/charge.h5 here"};
    return comparison_of({compared("whole", synthetic_campaign(3, 2)), std::move(other)});
  }

  std::string page_of(const Comparison& comparison, const std::string& fragment = "",
                      const std::string& script = "") const {
    std::string page = comparison_html(comparison, folder / "report.html");
    page.insert(page.rfind("</body>"), "<script>" + script + "</script>");
    return drawn(page, folder, fragment);
  }

  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) /
                                       ("comparison_page_" + std::to_string(::getpid()));
};

/// Whole hours below a million with the comma that the page groups them by.
std::string grouped(double hours) {
  const auto whole = std::lround(hours);
  return whole < 1000 ? std::to_string(whole) : fmt::format("{},{:03}", whole / 1000, whole % 1000);
}

TEST_F(ComparisonPage, ShowsTheFiguresOfEveryCampaign) {
  const auto comparison = new_and_unfinished();
  const auto page = page_of(comparison);
  const auto table = part_between(page, "id=\"answer-table\"", "</table>");
  const auto has = [&](const std::string& text) { return table.find(text) != std::string::npos; };
  const auto& [whole, unfinished] = std::tie(comparison.figures[0], comparison.figures[1]);
  EXPECT_TRUE(has(">" + grouped(whole.life_hours) + "<"));
  EXPECT_TRUE(has(">over " + grouped(unfinished.life_hours) + "<"));
  EXPECT_TRUE(has(fmt::format(">{:.1f}<", 1e3 * whole.height)));
  EXPECT_TRUE(has(fmt::format(">{:.2f} ± ", 1e-3 * whole.power)));
  EXPECT_TRUE(has(fmt::format(">{:.1f} ± ", unfinished.shoulder)));
  EXPECT_NE(part_between(page, "id=\"differing-table\"", "</table>").find(">9<"),
            std::string::npos);
  EXPECT_NE(page.find("unfinished: maps: 2 of 2 cycles"), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

// A line a campaign in each chart, and two profiles of each over each other.
TEST_F(ComparisonPage, DrawsALineForEachCampaign) {
  const auto page = page_of(new_and_unfinished());
  for (const char* chart : {"height", "life", "steel", "power", "shoulder", "toe", "hits"}) {
    const auto svg = part_between(page, std::string("id=\"") + chart + "-chart\"", "</figure>");
    EXPECT_EQ(count_of(svg, "class=\"series"), 2u) << chart;
    EXPECT_EQ(count_of(svg, "class=\"now\""), 2u) << chart;
  }
  EXPECT_EQ(count_of(part_between(page, "id=\"profiles-drawing\"", "</figure>"), "class=\"profile"),
            4u);
  EXPECT_EQ(count_of(part_between(page, "id=\"depth-rate-chart\"", "</figure>"), "class=\"series"),
            1u);
  EXPECT_NE(part_between(page, "id=\"section-map-0\"", "</figure>").find("cycle 0"),
            std::string::npos);
  EXPECT_NE(part_between(page, "id=\"section-map-1\"", "</figure>").find("not recorded"),
            std::string::npos);
}

// Each campaign shows the cycle whose hours are nearest to the share of its own life.
TEST_F(ComparisonPage, ChoosesTheNearestCycleOfEachCampaign) {
  const auto comparison = new_and_unfinished();
  const auto page = page_of(comparison, "#moment=10&units=inch",
                            "const slider = document.getElementById('cycle-slider');"
                            "slider.value = 60; slider.dispatchEvent(new Event('input'));");
  const auto words = part_between(page, "id=\"moments\"", "</p>");
  for (const auto& campaign : comparison.campaigns) {
    const auto off = [&](const MeasuredCharge& charge) {
      return std::abs(charge.operating_hours - 0.6 * campaign.data.life.hours);
    };
    const auto charges = measured_charges(campaign.data.history);
    const auto nearest = *std::ranges::min_element(charges, {}, off);
    EXPECT_GT(nearest.cycle, 0);
    EXPECT_NE(words.find(fmt::format("{}: cycle {}, {} h", campaign.name, nearest.cycle,
                                     grouped(nearest.operating_hours))),
              std::string::npos)
        << words;
  }
  EXPECT_NE(page.find(">60 % of the life<"), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

TEST_F(ComparisonPage, OfCampaignsThatHaveJustBegunSaysSo) {
  CampaignResults begun{};
  begun.sector = {0.52, 0.5, 12};
  begun.life = {false, 0.0, std::nan(""), std::nan(""), std::nan(""), "lifter height 10 mm"};
  const auto page = page_of(comparison_of({compared("one", begun), compared("two", begun)}));
  EXPECT_NE(part_between(page, "id=\"moments\"", "</p>").find("one: no cycle yet"),
            std::string::npos);
  EXPECT_NE(page.find("The cases are the same."), std::string::npos);
  EXPECT_EQ(complaints(folder), std::vector<std::string>());
}

}  // namespace
}  // namespace millwear::orchestrator
