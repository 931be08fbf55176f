#include <gtest/gtest.h>

#include "tests/support/sample_measurement.h"

namespace millwear::wear {
namespace {

LoadMeasurement measurement_with(MotionRecord motion) {
  LoadMeasurement measurement = sample_measurement;
  measurement.motion = motion;
  return measurement;
}
const LoadMeasurement measurement = measurement_with(MotionRecord::kept);
const Eigen::Vector2d crest(0.0, 0.1);

/// A particle of 2 kg that comes at 5 m/s, 3 m/s of it towards the liner, and touches nothing else.
WallContact hit_at(const Eigen::Vector2d& master, std::size_t particle) {
  WallContact hit = sample_contact(master, 0, 0.0);
  hit.impact_speed = 5.0;
  hit.impact_normal_speed = 3.0;
  hit.particle = particle;
  hit.company = Company::none;
  return hit;
}

Eigen::Vector2d on_the_plate() { return square_lifter().nodes.front(); }

ChargeMotion motion_of(const std::vector<WallContacts>& samples) {
  LoadAccumulator accumulator(square_lifter(), measurement);
  for (const auto& sample : samples) accumulator.add(sample);
  return *accumulator.finish().motion;
}

double hits(const ChargeMotion& motion) {
  return 0.5 * (motion.plate.mass.sum() + motion.lifter.mass.sum());
}

TEST(BareHits, AreCountedOnceEachWithMassEnergyPlaceAndBlock) {
  const auto motion = motion_of({{0.3, 0.0, {hit_at(crest, 1)}},
                                 {0.31, 0.0, {hit_at(crest, 1)}},
                                 {1.6, 0.0, {hit_at(on_the_plate(), 2)}}});
  EXPECT_EQ(motion.lifter.mass(180, 0), 2.0);
  EXPECT_EQ(motion.lifter.energy(180, 0), 25.0);
  EXPECT_EQ(motion.lifter.mass.sum(), 2.0);
  EXPECT_EQ(motion.plate.mass.col(3).sum(), 2.0);
  EXPECT_EQ(motion.plate.energy.sum(), 25.0);
}

TEST(BareHits, AreFastAndWithoutCompany) {
  WallContact slow = hit_at(crest, 1);
  slow.impact_normal_speed = 0.49;
  WallContact crowded = hit_at(crest, 2);
  crowded.company = Company::others;
  WallContact unknown = hit_at(crest, 3);
  unknown.company = Company::unknown;
  EXPECT_EQ(hits(motion_of({{0.3, 0.0, {slow, crowded, unknown}}})), 0.0);
  EXPECT_EQ(hits(motion_of({{0.3, 0.0, {slow, crowded, unknown, hit_at(crest, 4)}}})), 1.0);
}

// What slides down a face and meets the plate does not come from flight.
TEST(BareHits, BeginOffTheLiner) {
  WallContact face = hit_at(crest, 1);
  face.into_wall = Eigen::Vector3d::UnitX();
  face.impact_normal_speed = 0.0;
  const WallContact plate = hit_at(on_the_plate(), 1);
  EXPECT_EQ(hits(motion_of({{0.3, 0.0, {face}}, {0.31, 0.0, {face, plate}}})), 0.0);
  EXPECT_EQ(hits(motion_of({{0.3, 0.0, {face}}, {0.31, 0.0, {}}, {0.32, 0.0, {plate}}})), 1.0);
}

// Into the corner of plate and face in one sample: one hit, where it comes faster.
TEST(BareHits, IntoACornerAreOne) {
  WallContact face = hit_at(crest, 1);
  face.into_wall = Eigen::Vector3d::UnitX();
  face.impact_normal_speed = 2.0;
  const WallContact plate = hit_at(on_the_plate(), 1);
  for (const auto& contacts : {std::vector{face, plate}, std::vector{plate, face}}) {
    const auto motion = motion_of({{0.3, 0.0, contacts}});
    EXPECT_EQ(motion.plate.mass.sum(), 2.0);
    EXPECT_EQ(motion.lifter.mass.sum(), 0.0);
  }
}

TEST(BareHits, ThatTouchedBeforeTheMeasurementAreNone) {
  LoadAccumulator accumulator(square_lifter(), measurement);
  accumulator.begin_with({0.0, 0.0, {hit_at(crest, 1)}});
  accumulator.add({0.01, 0.0, {hit_at(crest, 1)}});
  EXPECT_EQ(hits(*accumulator.finish().motion), 0.0);
}

TEST(BareHits, AndTheCensusGoOnWithTheMeasurement) {
  LoadAccumulator accumulator(square_lifter(), measurement);
  accumulator.add_census(0.25, Census::Constant(1.0));
  accumulator.go_on_until(3.0);
  accumulator.add({2.9, 0.0, {hit_at(crest, 1)}});
  accumulator.add_census(2.9, Census::Constant(2.0));
  const auto motion = *accumulator.finish().motion;
  EXPECT_EQ(motion.census.cols(), 6);
  EXPECT_EQ(motion.census(0, 0), 1.0);
  EXPECT_EQ(motion.census(0, 5), 2.0);
  EXPECT_EQ(motion.lifter.mass.col(5).sum(), 2.0);
}

TEST(BareHits, AreNotRecordedUnlessAskedFor) {
  LoadAccumulator accumulator(square_lifter(), measurement_with(MotionRecord::none));
  accumulator.add({0.3, 0.0, {hit_at(crest, 1)}});
  EXPECT_FALSE(accumulator.finish().motion);
}

}  // namespace
}  // namespace millwear::wear
