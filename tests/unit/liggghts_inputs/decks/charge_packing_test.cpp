#include "liggghts_inputs/decks/charge_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "tests/support/example_case.h"
#include "tests/unit/liggghts_inputs/decks/charge_gaps.h"

namespace millwear::liggghts {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(PackCharge, PlacesEveryParticleApartAndOutOfTheSteel) {
  const Case mill = example_case();
  const auto charge = pack_charge(mill);
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c)
    EXPECT_EQ(std::ranges::count(charge, c, &PlacedParticle::particle_class),
              static_cast<long>(mill.charge.classes[c].count));
  EXPECT_GE(least_gap(mill, charge), 0.0);
  EXPECT_GE(least_clearance(mill, charge), 0.0);
  for (const auto& particle : charge) {
    EXPECT_GE(particle.centre.y(), 0.0);
    EXPECT_LT(particle.centre.y(), mill.slice_length);
  }
}

RC_GTEST_PROP(PackCharge, KeepsAnyChargeApartInAnySlice, ()) {
  Case mill = example_case();
  mill.slice_length = 0.001 * *rc::gen::inRange(100, 200);
  mill.dem.seed = *rc::gen::arbitrary<std::uint64_t>();
  mill.charge.classes = {{0, 0.001 * *rc::gen::inRange(40, 50), 60},
                         {1, 0.001 * *rc::gen::inRange(20, 40), 120},
                         {0, 0.001 * *rc::gen::inRange(5, 20), 120}};
  const auto charge = pack_charge(mill);
  RC_ASSERT(charge.size() == 300u);
  RC_ASSERT(least_gap(mill, charge) >= 0.0);
  RC_ASSERT(least_clearance(mill, charge) >= 0.0);
}

TEST(PackCharge, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot) {
  Case mill = example_case();
  const auto first = charge_data_file(mill, pack_charge(mill));
  EXPECT_EQ(charge_data_file(mill, pack_charge(mill)), first);
  mill.dem.seed = 2;
  EXPECT_NE(charge_data_file(mill, pack_charge(mill)), first);
}

// A circle's part below a level that leans by 40 degrees has its middle 40 degrees from six
// o'clock.
TEST(PackCharge, LiesLowAndLeansToTheRisingSide) {
  Case mill = example_case();
  mill.charge.classes = {{0, 0.03, 1500}};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& particle : pack_charge(mill)) middle += particle.centre / 1500.0;
  EXPECT_LT(middle.z(), 0.0);
  EXPECT_NEAR(angle_from_six_oclock(middle.x(), middle.z()) * 180.0 / std::numbers::pi, 40.0, 5.0);
}

// 200 balls of 100 mm are 0.105 m3 of steel; 0.2 m of the mill hold less than 0.157 m3, and balls
// thrown in at random jam near 38 % of it.
TEST(PackCharge, RefusesAChargeThatDoesNotFit) {
  Case mill = example_case();
  mill.charge.classes = {{0, 0.1, 200}};
  EXPECT_THAT([&] { static_cast<void>(pack_charge(mill)); },
              ThrowsMessage<InputError>(HasSubstr("of 200 particles of 0.1 m find no place")));
}

}  // namespace
}  // namespace millwear::liggghts
