#include "mill/case/time_step.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/example_case.h"

namespace millwear {
namespace {

RC_GTEST_PROP(TimeStep, PitchTakesWholeStepsUnderTheLimit, ()) {
  Case mill = example_case();
  mill.speed = *rc::gen::inRange(1, 1000) * 1e-2;
  mill.dem.rayleigh_fraction = *rc::gen::inRange(1, 50) * 1e-2;
  if (*rc::gen::arbitrary<bool>()) {
    mill.dem.longest_time_step = *rc::gen::inRange(1, 1000) * 1e-7;
  }
  const StepPlan plan = plan_steps(mill);
  const double limit = std::min(mill.dem.rayleigh_fraction * shortest_rayleigh_time(mill),
                                mill.dem.longest_time_step.value_or(1.0));
  const double pitch_time = mill.liner.sector.pitch() / mill.speed;
  const auto steps = static_cast<double>(plan.steps_per_pitch);
  RC_ASSERT(std::abs(steps * plan.time_step - pitch_time) < 1e-12 * pitch_time);
  RC_ASSERT(plan.time_step <= limit * (1.0 + 1e-12));
  RC_ASSERT(plan.steps_per_pitch == 1 || pitch_time / (steps - 1.0) > limit * (1.0 - 1e-12));
  RC_ASSERT(plan.steps_per_revolution(12) == 12 * plan.steps_per_pitch);
}

TEST(TimeStep, WantedStepStandsInPlaceOfTheShare) {
  Case mill = example_case();
  mill.dem.time_step = 1.5e-5;
  EXPECT_LE(plan_steps(mill).time_step, 1.5e-5);
  EXPECT_NEAR(plan_steps(mill).time_step, 1.5e-5, 1e-8);
}

// Ore of 20 mm has 2.07e-4 s, steel of 50 mm 2.70e-4 s, ore of 30 mm more: the least one counts.
TEST(TimeStep, WorstClassCounts) {
  EXPECT_DOUBLE_EQ(shortest_rayleigh_time(example_case()),
                   rayleigh_time(0.01, 2700.0, 7.55e7, 0.2));
}

}  // namespace
}  // namespace millwear
