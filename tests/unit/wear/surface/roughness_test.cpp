#include "wear/surface/roughness.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double radius = 0.02;

TEST(Roughness, OfARingIsNone) { EXPECT_EQ(roughness(bare_ring(), radius), 0.0); }

// Two feet of 90 degrees, r^2 (1 - pi / 4) each.
TEST(Roughness, OfANewLifterIsThatOfItsFeet) {
  const auto lifter = square_lifter();
  const double feet = 2.0 * radius * radius * (1.0 - std::numbers::pi / 4.0);
  EXPECT_NEAR(roughness(lifter, radius), feet / arc_lengths(lifter).back(), 0.05 * feet);
}

/// A plate with a notch 4 mm wide and `depth` deep, and with an edge as high.
LinerProfile notched(double depth) {
  const double half = 0.5 * sample_sector.pitch();
  return {sample_sector,
          {point_at(sample_sector, 1.0, -half),
           {-0.1, 0.0},
           {-0.002, 0.0},
           {0.0, -depth},
           {0.002, 0.0},
           {0.1, 0.0},
           point_at(sample_sector, 1.0, half)}};
}

TEST(Roughness, GrowsWithADeeperNotch) {
  const double length = arc_lengths(notched(0.004)).back();
  const double more = roughness(notched(0.004), radius) - roughness(notched(0.002), radius);
  EXPECT_NEAR(more, 0.5 * 0.004 * 0.002 / length, 0.02 * more);
}

}  // namespace
}  // namespace millwear::wear
