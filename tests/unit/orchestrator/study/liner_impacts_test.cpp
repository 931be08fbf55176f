#include "orchestrator/study/liner_impacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear::orchestrator {
namespace {

SpectrumRow hit(double energy, double events_per_second, double power) {
  return {0,      CollisionWith::liner, "steel_30mm",      "",   EnergyDirection::normal,
          energy, 10.0 * energy,        events_per_second, power};
}

// Of 1 + 2 + 3 W the hits above 0.1 J make 3 W, half of all; those above 1 J make none of it.
TEST(LinerImpacts, CountHitsAboveEachEnergyAndHalveThePower) {
  const auto impacts =
      liner_impacts({hit(0.001, 100.0, 1.0), hit(0.1, 1.0, 3.0), hit(0.01, 10.0, 2.0)});
  EXPECT_DOUBLE_EQ(impacts.power, 6.0);
  EXPECT_DOUBLE_EQ(impacts.half_energy, 0.1);
  ASSERT_EQ(impacts.exceeded.size(), 3U);
  EXPECT_DOUBLE_EQ(impacts.exceeded[0].energy, 0.001);
  EXPECT_DOUBLE_EQ(impacts.exceeded[0].hits_per_second, 111.0);
  EXPECT_DOUBLE_EQ(impacts.exceeded[2].hits_per_second, 1.0);
}

TEST(LinerImpacts, AreOfTheNewLinerAndOfTheNormalDirectionAlone) {
  auto later = hit(0.1, 1.0, 3.0);
  later.cycle = 1;
  auto shear = hit(0.1, 1.0, 3.0);
  shear.direction = EnergyDirection::shear;
  auto between = hit(0.1, 1.0, 3.0);
  between.contact = CollisionWith::particles;
  EXPECT_DOUBLE_EQ(
      liner_impacts({hit(0.1, 2.0, 1.0), hit(0.1, 3.0, 1.0), later, shear, between}).power, 2.0);
  const auto none = liner_impacts({later, shear, between});
  EXPECT_TRUE(std::isnan(none.power));
  EXPECT_TRUE(none.exceeded.empty());
}

}  // namespace
}  // namespace millwear::orchestrator
