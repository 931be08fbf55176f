#include "wear/charge/charge_fields.h"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

namespace millwear::wear {
namespace {

using Eigen::Vector3d;
using testing::DoubleNear;

const SectionGrid grid{1.0, 200};
constexpr double slice = 0.25;

Eigen::Index cell_at(double x, double z) {
  const auto line = [](double c) { return static_cast<Eigen::Index>((c + 1.0) / 0.01); };
  return line(x) + 200 * line(z);
}

TEST(ChargeFields, OfASphereHaveItsVolumeMassAndMomentum) {
  ChargeFieldSums sums(grid, slice, 2);
  sums.begin_instant();
  sums.add({{0.303, 0.1, -0.402}, {1.0, 2.0, 3.0}, 0.1, 4.0, 1});
  const ChargeFields& fields = sums.fields();
  const double cell_volume = 0.01 * 0.01 * slice;
  EXPECT_THAT(fields.sums.col(0).sum() * cell_volume, DoubleNear(4.0 / 3.0 * M_PI * 1e-3, 1e-12));
  EXPECT_THAT(fields.sums.col(1).sum(), DoubleNear(4.0, 1e-12));
  EXPECT_THAT(fields.sums.col(2).sum(), DoubleNear(4.0, 1e-12));
  EXPECT_THAT(fields.sums.col(4).sum(), DoubleNear(12.0, 1e-12));
  EXPECT_THAT(fields.sums.col(5).sum(), DoubleNear(4.0 * 14.0, 1e-11));
  EXPECT_THAT(fields.class_mass.col(1).sum(), DoubleNear(4.0, 1e-12));
  EXPECT_EQ(fields.class_mass.col(0).sum(), 0.0);
}

// The share of a line along the axis that lies in the sphere is its chord over the slice's length,
// to what ten cells a radius leave.
TEST(ChargeFields, AreOccupiedAsLongAsTheChordOfASphere) {
  ChargeFieldSums sums(grid, slice, 1);
  sums.begin_instant();
  sums.begin_instant();
  sums.add({{0.305, 0.1, -0.405}, Vector3d::Zero(), 0.1, 4.0, 0});
  const FieldMap map = map_of(sums.fields());
  EXPECT_THAT(map.occupied[cell_at(0.305, -0.405)], DoubleNear(0.5 * 0.2 / slice, 0.004));
  EXPECT_THAT(map.occupied[cell_at(0.365, -0.405)], DoubleNear(0.5 * 0.16 / slice, 0.004));
  EXPECT_EQ(map.occupied[cell_at(0.415, -0.405)], 0.0);
}

TEST(ChargeFields, HaveTheMeanVelocityAndTheTemperatureOfWhatPassesACell) {
  ChargeFieldSums sums({1.0, 4}, slice, 1);
  sums.begin_instant();
  for (const double vx : {1.0, 3.0}) sums.add({{0.25, 0.1, 0.25}, {vx, 0.0, -1.0}, 0.01, 2.0, 0});
  const FieldMap map = map_of(sums.fields());
  EXPECT_EQ(map.velocity_x[10], 2.0);
  EXPECT_EQ(map.velocity_z[10], -1.0);
  EXPECT_THAT(map.temperature[10], DoubleNear(1.0 / 3.0, 1e-12));
  EXPECT_EQ(map.class_share(10, 0), 1.0);
  EXPECT_TRUE(std::isnan(map.velocity_x[0]));
}

TEST(ChargeFields, CountASphereBetweenTheMiddlesOfCellsToTheOneOfItsCentre) {
  ChargeFieldSums sums({1.0, 4}, slice, 1);
  sums.begin_instant();
  sums.add({{0.45, 0.1, 0.45}, Vector3d::Zero(), 0.01, 2.0, 0});
  EXPECT_EQ(sums.fields().sums(10, 1), 2.0);
}

TEST(ChargeFields, KeepWhatLiesOutsideInTheOutermostCells) {
  ChargeFieldSums sums({1.0, 4}, slice, 1);
  sums.begin_instant();
  sums.add({{1.5, 0.1, -7.0}, Vector3d::Zero(), 0.01, 2.0, 0});
  EXPECT_EQ(sums.fields().sums(3, 1), 2.0);
}

TEST(ChargeFields, HaveThePowerOfCollisionsForAVolume) {
  ChargeFieldSums sums({1.0, 4}, slice, 1);
  for (int step = 0; step < 10; ++step) {
    sums.add_contact({0.25, 0.1, 0.25}, 3.0, 1.5, 1e-4);
    sums.add_pair_time(1e-4);
  }
  const FieldMap map = map_of(sums.fields());
  EXPECT_THAT(map.normal_power[10], DoubleNear(3.0 / (0.25 * slice), 1e-9));
  EXPECT_THAT(map.shear_power[10], DoubleNear(1.5 / (0.25 * slice), 1e-9));
}

TEST(ChargeFields, OfTwoPartsOfTheTimeAreTheirSum) {
  ChargeFieldSums whole(grid, slice, 1);
  ChargeFieldSums first(grid, slice, 1);
  ChargeFieldSums last(grid, slice, 1);
  for (auto* sums : {&first, &last}) {
    const ChargeParticle particle{{0.1, 0.1, sums == &first ? 0.2 : -0.5}, {1, 0, 0}, 0.03, 1.0, 0};
    for (auto* into : {sums, &whole}) {
      into->begin_instant();
      into->add(particle);
      into->add_contact(particle.place, 1.0, 2.0, 1e-4);
      into->add_pair_time(1e-4);
    }
  }
  const ChargeFields sum = sum_of(first.fields(), last.fields());
  EXPECT_EQ(sum.instants, 2.0);
  EXPECT_EQ(sum.sums, whole.fields().sums);
  EXPECT_EQ(sum.class_mass, whole.fields().class_mass);
  EXPECT_EQ(sum.normal_dissipation, whole.fields().normal_dissipation);
  EXPECT_THROW((void)sum_of(sum, no_charge_fields({1.0, 10}, slice, 1)), std::logic_error);
}

// One cell of 25 around it in the middle, one of 9 in the corner.
TEST(ChargeFields, AverageOverFiveByFiveCells) {
  const SectionGrid ten{1.0, 10};
  Eigen::VectorXd values = Eigen::VectorXd::Zero(100);
  values[55] = 25.0;
  values[0] = 9.0;
  const Eigen::VectorXd means = averaged(ten, values);
  EXPECT_THAT(means[55], DoubleNear(1.0, 1e-12));
  EXPECT_THAT(means[33], DoubleNear(1.0, 1e-12));
  EXPECT_EQ(means[58], 0.0);
  EXPECT_THAT(means[0], DoubleNear(1.0, 1e-12));
}

}  // namespace
}  // namespace millwear::wear
