#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "liggghts_inputs/stretch.h"
#include "tests/unit/mill/example_case.h"

namespace millwear::liggghts {
namespace {

constexpr StepPlan plan{4e-5, 1250};

// 12 rows: two revolutions are 24 pitches, one is 12, and it settles for two.
TEST(StretchSteps, AreWholeRevolutionsWhereAsked) {
  const Case mill = example_case();
  const auto mixing = mixing_steps(mill, plan);
  EXPECT_EQ(mixing.settle_steps, 24 * 1250);
  EXPECT_EQ(mixing.measure_steps, 0);
  const auto measuring = measuring_steps(mill, plan);
  EXPECT_EQ(measuring.settle_steps, 2 * 1250);
  EXPECT_EQ(measuring.measure_steps, 12 * 1250);
  EXPECT_DOUBLE_EQ(measuring.settle_time(), 0.1);
  EXPECT_DOUBLE_EQ(measuring.measure_time(), 0.6);
  EXPECT_DOUBLE_EQ(measuring.sample_interval(), 8e-4);
  EXPECT_EQ(measuring.samples(), 750);
}

RC_GTEST_PROP(StretchSteps, TakeWholePitchesAndNotLessThanAsked, ()) {
  Case mill = example_case();
  mill.liner.sector.rows = *rc::gen::inRange(3, 90);
  mill.dem.mix_revolutions = *rc::gen::inRange(1, 400) / 100.0;
  mill.dem.measure_revolutions = *rc::gen::inRange(1, 400) / 100.0;
  const auto mixing = mixing_steps(mill, plan);
  const auto measuring = measuring_steps(mill, plan);
  const double revolution = static_cast<double>(plan.steps_per_revolution(mill.liner.sector.rows));
  for (const auto& [steps, revolutions] :
       {std::pair{mixing.settle_steps, mill.dem.mix_revolutions},
        {measuring.measure_steps, mill.dem.measure_revolutions}}) {
    const double asked = revolutions * revolution;
    RC_ASSERT(steps % plan.steps_per_pitch == 0);
    RC_ASSERT(static_cast<double>(steps) > asked - 1e-3);
    RC_ASSERT(static_cast<double>(steps) < asked + static_cast<double>(plan.steps_per_pitch));
  }
  RC_ASSERT(measuring.settle_steps % plan.steps_per_pitch == 0);
}

RC_GTEST_PROP(StretchSteps, CountTheSamplesThatADumpWrites, ()) {
  const StretchSteps steps{1e-5, *rc::gen::inRange(0L, 300L), *rc::gen::inRange(1L, 300L),
                           *rc::gen::inRange(1L, 40L)};
  long samples = 0;
  for (long step = steps.settle_steps + 1; step <= steps.total(); ++step)
    samples += step % steps.sample_steps == 0 ? 1 : 0;
  RC_ASSERT(steps.samples() == samples);
}

}  // namespace
}  // namespace millwear::liggghts
