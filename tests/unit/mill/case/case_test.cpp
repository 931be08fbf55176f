#include "mill/case/case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/case_file/case_warnings.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

TEST(Case, PairIsFoundInEitherOrder) {
  const Case mill = example_case();
  EXPECT_EQ(&pair_of(mill, 0, 1), &pair_of(mill, 1, 0));
  EXPECT_EQ(pair_of(mill, 1, 0).sliding_friction, 0.5);
}

TEST(Case, MissingPairIsNamed) {
  Case mill = example_case();
  mill.pairs.pop_back();
  EXPECT_THROW(static_cast<void>(pair_of(mill, 1, 1)), InputError);
}

TEST(Case, TotalsAddUpClasses) {
  const Case mill = example_case();
  const double steel = 100 * sphere_volume(0.05);
  const double ore = 1000 * sphere_volume(0.03) + 3000 * sphere_volume(0.02);
  EXPECT_EQ(totals(mill).particles, 4100U);
  EXPECT_DOUBLE_EQ(totals(mill).solid_volume, steel + ore);
  EXPECT_DOUBLE_EQ(totals(mill).mass, 7800.0 * steel + 2700.0 * ore);
}

// Inside volume: the plate's cylinder less 12 lifters.
TEST(Case, InsideVolumeLeavesOutTheLifters) {
  const Case mill = example_case();
  const double expected =
      (std::numbers::pi * 0.25 - 12.0 * lifter_area(mill.liner)) * mill.slice_length;
  EXPECT_NEAR(inside_volume(mill), expected, 1e-12);
  EXPECT_DOUBLE_EQ(computed_filling(mill), totals(mill).solid_volume / 0.6 / inside_volume(mill));
}

TEST(Case, DiametersAndModuli) {
  const Case mill = example_case();
  EXPECT_EQ(largest_diameter(mill), 0.05);
  EXPECT_EQ(smallest_diameter(mill), 0.02);
  EXPECT_DOUBLE_EQ(softened_shear_modulus(mill, 0), 7.752e8);
}

TEST(Warnings, NoneForASoundMill) {
  Case mill = example_case();
  mill.charge.declared.total = filling_inside_plate(mill);
  EXPECT_TRUE(warnings(mill).empty());
}

TEST(Warnings, EachOddityHasOne) {
  Case mill = example_case();
  mill.charge.declared = {};
  mill.slice_length = 0.09;
  EXPECT_EQ(warnings(mill).size(), 1U);
  mill.speed = 6.0;  // critical: sqrt(9.81 / 0.475) = 4.54 rad/s
  EXPECT_EQ(warnings(mill).size(), 2U);
  mill.wear.bins = 20;
  EXPECT_EQ(warnings(mill).size(), 3U);
  mill.charge.declared.total = 2.0 * filling_inside_plate(mill);
  EXPECT_EQ(warnings(mill).size(), 4U);
  mill.wear.mechanisms.push_back({WearLaw::incident_energy, 1e-12});
  EXPECT_EQ(warnings(mill).size(), 5U);
  mill.dem.sample_every_steps = 1;
  EXPECT_EQ(warnings(mill).size(), 4U);
  mill.wear.time_blocks = 4;
  EXPECT_EQ(warnings(mill).size(), 5U);
}

}  // namespace
}  // namespace millwear
