#include "orchestrator/gauge/gauge_comparison.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear::orchestrator {
namespace {

const LinerSector sector{0.55, 0.5, 12};

LinerProfile lifter(double height) { return profile_of(sector, {height, 0.05, 0.3, 0.2}); }

HistoryRow row(double hours, double height) {
  HistoryRow result{};
  result.operating_hours = hours;
  result.lifter_height = height;
  result.face_angle = 0.3 + 0.001 * hours;
  result.plate_thickness = 0.05;
  return result;
}

const std::vector<HistoryRow> history = {row(0, 0.05), row(100, 0.04), row(200, 0.02)};
const std::vector<ProfileRow> profiles = {{0, 0, 0.0, lifter(0.05).nodes, {}},
                                          {0, 1, 100.0, lifter(0.04).nodes, {}},
                                          {0, 2, 200.0, lifter(0.02).nodes, {}}};

GaugeReading reading(double hours, double height) {
  return {hours, height, {}, lifter(height), 1e-3};
}

// At 160 h the line from 40 to 20 mm stands at 28 mm; the nearest step is that of 200 h.
TEST(GaugeComparison, InterpolatesInTime) {
  const auto found = compare_with({reading(160, 0.03)}, history, profiles, sector);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].predicted && found[0].difference);
  EXPECT_NEAR(found[0].predicted->lifter_height, 0.028, 1e-12);
  EXPECT_NEAR(found[0].predicted->face_angle, 0.46, 1e-12);
  EXPECT_EQ(found[0].predicted->profile_hours, 200.0);
  EXPECT_NEAR(found[0].difference->lifter_height, 0.02 - 0.03, 1e-12);
  EXPECT_LT(found[0].difference->signed_area, 0.0);
  EXPECT_NEAR(rms_of_heights(found), 0.002, 1e-12);
}

TEST(GaugeComparison, StandsOnTheStepsThemselves) {
  const auto found = compare_with({reading(0, 0.05), reading(100, 0.04), reading(200, 0.02)},
                                  history, profiles, sector);
  for (const auto& each : found) {
    EXPECT_EQ(each.predicted->lifter_height, each.measured.lifter_height);
    EXPECT_EQ(each.predicted->profile_hours, each.measured.operating_hours);
    EXPECT_EQ(each.difference->hausdorff, 0.0);
  }
  EXPECT_EQ(rms_of_heights(found), 0.0);
}

TEST(GaugeComparison, SaysNothingBeyondTheCampaign) {
  const auto found = compare_with({reading(201, 0.01)}, history, profiles, sector);
  EXPECT_FALSE(found.at(0).predicted);
  EXPECT_FALSE(found.at(0).difference);
  EXPECT_TRUE(std::isnan(rms_of_heights(found)));
  EXPECT_FALSE(compare_with({reading(1, 0.01)}, {}, {}, sector).at(0).predicted);
}

TEST(GaugeComparison, HeightAloneHasNoProfileToCompare) {
  const auto found = compare_with({{50, std::nullopt, 0.045, {}, 1e-3}}, history, profiles, sector);
  EXPECT_TRUE(found.at(0).predicted);
  EXPECT_FALSE(found.at(0).difference);
  EXPECT_TRUE(std::isnan(rms_of_heights(found)));
}

TEST(GaugeComparison, RefusesAHistoryWithoutItsProfiles) {
  EXPECT_THROW(static_cast<void>(compare_with({reading(100, 0.04)}, history, {}, sector)),
               ResultRejected);
}

TEST(GaugeComparison, IsWrittenAsATable) {
  const std::string text = comparison_csv(
      compare_with({{50, 0.044, {}, {}, 1e-3}, {300, 0.01, {}, {}, 1e-3}}, history, {}, sector));
  EXPECT_THAT(text, testing::StartsWith("# millwear comparison 1\noperating_hours,"));
  EXPECT_THAT(text, testing::HasSubstr("\n50,0.044,0.045,0.001,,"));
  EXPECT_THAT(text, testing::HasSubstr("\n300,0.01,,0.001,,,,,,,,,\n"));
}

}  // namespace
}  // namespace millwear::orchestrator
