#include "wear/record/charge_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr TurningMill mill{.speed = 2.0, .plate_radius = 0.5, .crest_radius = 0.45};

double part(const Census& census, ChargePart which) {
  return census[static_cast<Eigen::Index>(which)];
}

/// At `radius` from the axis, `angle` behind six o'clock along the rotation (on the side that
/// rises), moving with the mill but for `slip` towards the axis.
ParticleMotion turning(double radius, double angle, double mass, double slip = 0.0) {
  const Eigen::Vector3d outward(-std::sin(angle), 0.0, -std::cos(angle));
  const Eigen::Vector3d along(-std::cos(angle), 0.0, std::sin(angle));
  return {radius * outward, mill.speed * radius * along - slip * outward, mass, Flight::touching};
}

Census census_of(std::initializer_list<ParticleMotion> particles) {
  Census census = Census::Zero();
  for (const auto& particle : particles) count(census, mill, particle);
  return census;
}

TEST(ChargeMotion, OfARigidlyTurningChargeIsAllLocked) {
  const Census census = census_of({turning(0.48, 0.2, 1.0), turning(0.3, 0.9, 2.0)});
  EXPECT_EQ(part(census, ChargePart::all), 3.0);
  EXPECT_EQ(part(census, ChargePart::airborne), 0.0);
  EXPECT_EQ(part(census, ChargePart::ascending), 3.0);
  EXPECT_EQ(part(census, ChargePart::locked), 3.0);
  EXPECT_EQ(part(census, ChargePart::between), 1.0);
  EXPECT_EQ(part(census, ChargePart::between_locked), 1.0);
}

// omega R = 1 m/s, so 0.05 m/s is the limit, whatever the particle's own radius.
TEST(ChargeMotion, EndsTheDeadZoneAtFivePerCentOfThePlatesSpeed) {
  const Census census = census_of({turning(0.2, 0.5, 1.0, 0.049), turning(0.2, 0.5, 2.0, 0.051),
                                   turning(0.48, 0.5, 4.0, 0.051)});
  EXPECT_EQ(part(census, ChargePart::ascending), 7.0);
  EXPECT_EQ(part(census, ChargePart::locked), 1.0);
  EXPECT_EQ(part(census, ChargePart::between), 4.0);
  EXPECT_EQ(part(census, ChargePart::between_locked), 0.0);
}

TEST(ChargeMotion, CountsWhatFliesOrGoesBackToNoOtherPart) {
  ParticleMotion flying = turning(0.48, 0.5, 2.0);
  flying.flight = Flight::airborne;
  ParticleMotion back = turning(0.48, 0.5, 4.0);
  back.velocity *= -1.0;
  const Census census = census_of({flying, back});
  EXPECT_EQ(part(census, ChargePart::all), 6.0);
  EXPECT_EQ(part(census, ChargePart::airborne), 2.0);
  EXPECT_EQ(part(census, ChargePart::ascending), 0.0);
  EXPECT_EQ(part(census, ChargePart::locked), 0.0);
}

/// Two blocks of one second. Of 10 kg, 2 and 4 kg ascend, 1 and 3 kg of them locked.
ChargeMotion two_blocks() {
  ChargeMotion motion = no_charge_motion(2);
  motion.census.col(0) << 10.0, 1.0, 2.0, 1.0, 0.0, 0.0;
  motion.census.col(1) << 10.0, 2.0, 4.0, 3.0, 0.0, 0.0;
  add_hit(motion.plate, -100.0 * degree, 0.5, 3.0, 0);
  add_hit(motion.lifter, 100.0 * degree, 0.5, 4.0, 1);
  add_hit(motion.lifter, -1.0 * degree, 1.0, 5.0, 1);
  return motion;
}

// 4 of 6 kg are locked; the blocks are off by 1 - 4/6 2 = -1/3 and 3 - 4/6 4 = 1/3 kg, so the mean
// of 2 kg by sqrt((1/9 + 1/9) / (2 1)) = 1/3 kg, and of the 3 kg that ascend that is 1/9.
TEST(ChargeMotion, TellsSharesWithTheErrorOfARatio) {
  const auto found = motion_measures(two_blocks(), {2.0, 2.0 * std::numbers::pi, 10.0});
  EXPECT_DOUBLE_EQ(found.dead_zone_share.value, 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(found.dead_zone_share.error, 1.0 / 9.0);
  EXPECT_DOUBLE_EQ(found.airborne_share.value, 0.15);
  EXPECT_DOUBLE_EQ(found.airborne_share.error, 0.05);
  EXPECT_DOUBLE_EQ(found.packed_share.value, 0.0);
  EXPECT_TRUE(std::isnan(found.between_locked_share.value));
  EXPECT_TRUE(std::isnan(found.between_locked_share.error));
}

// 12 J and 2 kg in two seconds, which are two revolutions; 8 J of it between twelve and six o'clock
// and 3 J on the plate. The blocks have 3 and 9 W.
TEST(ChargeMotion, TellsThePowerOfHitsAndWhereTheyLand) {
  const auto found = motion_measures(two_blocks(), {2.0, 2.0 * std::numbers::pi, 10.0});
  EXPECT_DOUBLE_EQ(found.bare_hit_power.value, 6.0);
  EXPECT_DOUBLE_EQ(found.bare_hit_power.error, 3.0);
  EXPECT_DOUBLE_EQ(found.bare_hit_falling_power.value, 4.0);
  EXPECT_DOUBLE_EQ(found.bare_hit_plate_power.value, 1.5);
  EXPECT_DOUBLE_EQ(found.bare_hit_mass_share.value, 0.1);
  EXPECT_DOUBLE_EQ(found.bare_hit_mass_share.error, 0.05);
}

TEST(ChargeMotion, KnowsNoErrorFromOneBlockAndNoShareOfNothing) {
  ChargeMotion motion = no_charge_motion(1);
  motion.census.col(0) << 10.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  const auto found = motion_measures(motion, {1.0, 1.0, 10.0});
  EXPECT_DOUBLE_EQ(found.airborne_share.value, 0.1);
  EXPECT_TRUE(std::isnan(found.airborne_share.error));
  EXPECT_TRUE(std::isnan(found.dead_zone_share.value));
  EXPECT_EQ(found.bare_hit_power.value, 0.0);
  EXPECT_TRUE(std::isnan(unknown_motion().airborne_share.value));
}

TEST(ChargeMotion, KeepsItsBlocksWhereTheMeasurementGoesOn) {
  const ChargeMotion before = two_blocks();
  const ChargeMotion longer = with_blocks(before, 3);
  EXPECT_EQ(longer.census.leftCols(2), before.census);
  EXPECT_EQ(longer.census.col(2).sum(), 0.0);
  EXPECT_EQ(longer.lifter.energy.leftCols(2), before.lifter.energy);
  EXPECT_EQ(longer.plate.mass.cols(), 3);
}

// The plate between square lifters is deepest at (0.2, 0), at a radius of sqrt(1.04), and their
// crests are at 0.9. A fifth of that lift stands for the plate; without a lift all is plate.
TEST(ChargeMotion, TakesTheLowestFifthOfTheLiftForThePlate) {
  const LinerProfile lifter = square_lifter();
  const double lowest = std::sqrt(1.04);
  EXPECT_NEAR(plate_limit_radius(lifter, 1e-3), lowest - 0.2 * (lowest - 0.9), 1e-12);
  EXPECT_NEAR(plate_limit_radius(lifter, 0.05), lowest - 0.05, 1e-12);
  EXPECT_EQ(plate_limit_radius(bare_ring(), 1e-3), 0.0);
}

}  // namespace
}  // namespace millwear::wear
