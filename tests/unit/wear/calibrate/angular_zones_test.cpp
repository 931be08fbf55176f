#include "wear/calibrate/angular_zones.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

/// A lifter whose faces may lean over: the top up to 50 mm beyond the foot.
LinerProfile leaning_lifter() {
  const auto tilt = [](int low, int high) { return 1e-3 * *rc::gen::inRange(low, high); };
  const double half = 0.5 * sample_sector.pitch();
  return {sample_sector,
          {point_at(sample_sector, 1.0, -half),
           {-0.05, 0.001},
           {-0.05 + tilt(-50, 30), 0.1},
           {0.05 + tilt(-30, 50), 0.09},
           {0.05, 0.001},
           point_at(sample_sector, 1.0, half)}};
}

RC_GTEST_PROP(AngularZones, SumToTheWholeProfile, ()) {
  const LinerProfile profile = leaning_lifter();
  const auto zones = *rc::gen::inRange<Eigen::Index>(1, 40);
  RC_ASSERT(std::abs(steel_by_zone(profile, zones).sum() - steel_area(profile)) < 1e-14);
  RC_ASSERT(std::abs(length_by_zone(profile, zones).sum() - arc_lengths(profile).back()) < 1e-14);
}

// Two zones of one are its halves, also where a face leans over the border.
RC_GTEST_PROP(AngularZones, OfHalfTheWidthMakeOneOfTheWhole, ()) {
  const LinerProfile profile = leaning_lifter();
  const auto zones = *rc::gen::inRange<Eigen::Index>(1, 20);
  const Eigen::VectorXd wide = steel_by_zone(profile, zones);
  const Eigen::VectorXd narrow = steel_by_zone(profile, 2 * zones);
  for (Eigen::Index z = 0; z < zones; ++z)
    RC_ASSERT(std::abs(wide[z] - narrow[2 * z] - narrow[2 * z + 1]) < 1e-14);
}

// A ring of facets: every zone of ten has four chords of a circle of radius 1 under the angle
// pitch / 40, in a shell of 1.05.
TEST(AngularZones, OfARingAreAlike) {
  const double turn = sample_sector.pitch() / 40.0;
  const double steel = 0.5 * 1.05 * 1.05 * 4.0 * turn - 4.0 * 0.5 * std::sin(turn);
  for (const double zone : steel_by_zone(bare_ring(), 10)) EXPECT_NEAR(zone, steel, 1e-14);
  for (const double zone : length_by_zone(bare_ring(), 10))
    EXPECT_NEAR(zone, 4.0 * 2.0 * std::sin(0.5 * turn), 1e-14);
}

// A lifter from -2.9 to 2.9 degrees adds its section to the middle one of three zones of 12.
TEST(AngularZones, KnowWhereTheLifterStands) {
  const Eigen::VectorXd steel = steel_by_zone(square_lifter(), 3);
  EXPECT_NEAR(steel[0], steel[2], 1e-14);
  EXPECT_GT(steel[1] - steel[0], 0.0099);
  EXPECT_EQ(zone_of(sample_sector, {0.0, 0.1}, 3), 1);
  EXPECT_EQ(zone_of(sample_sector, point_at(sample_sector, 1.0, 0.51 * sample_sector.pitch()), 3),
            0);
  EXPECT_EQ(zone_of(sample_sector, point_at(sample_sector, 1.0, -0.51 * sample_sector.pitch()), 3),
            2);
}

}  // namespace
}  // namespace millwear::wear
