#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/case/case.h"
#include "mill/case/time_step.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

// Steel of the 2006 paper, 63 mm: pi 0.0315 sqrt(7800/7.752e8) / (0.1631 0.29 + 0.8766) = 3.3976e-4
// s.
TEST(RayleighTime, OfASteelBall) {
  EXPECT_NEAR(rayleigh_time(0.0315, 7800.0, 7.752e8, 0.29), 3.3976e-4, 1e-8);
}

TEST(RayleighTime, GrowsWithRadiusAndRootOfDensity) {
  const double one = rayleigh_time(0.01, 1000.0, 1e9, 0.25);
  EXPECT_NEAR(rayleigh_time(0.02, 1000.0, 1e9, 0.25), 2.0 * one, 1e-18);
  EXPECT_NEAR(rayleigh_time(0.01, 4000.0, 1e9, 0.25), 2.0 * one, 1e-18);
  EXPECT_NEAR(rayleigh_time(0.01, 1000.0, 4e9, 0.25), 0.5 * one, 1e-18);
}

// The mill owner's form: 42.3 / sqrt(D - d) rpm, D and d in m.
TEST(CriticalSpeed, AgreesWithTheRuleOfThumb) {
  const double rpm = critical_speed({4.0, 3.9005, 52}, 0.18) * 30.0 / std::numbers::pi;
  EXPECT_NEAR(rpm, 42.3 / std::sqrt(7.801 - 0.18), 2e-3);
}

TEST(CriticalSpeed, FractionIsOneAtTheCriticalSpeed) {
  Case mill = example_case();
  mill.speed = critical_speed(mill.liner.sector, 0.05);
  EXPECT_DOUBLE_EQ(critical_speed_fraction(mill), 1.0);
}

}  // namespace
}  // namespace millwear
