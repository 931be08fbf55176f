#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/base/failure.h"
#include "tests/support/example_case.h"

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
  EXPECT_DOUBLE_EQ(static_cast<double>(measuring.settle_steps) * measuring.time_step, 0.1);
  EXPECT_DOUBLE_EQ(measuring.measure_time(), 0.6);
  EXPECT_DOUBLE_EQ(measuring.sample_interval(), 8e-4);
  EXPECT_EQ(measuring.samples(), 750);
}

// 40 rows are mixed in pieces of two pitches.
TEST(StretchSteps, OfAMixingThatMayEndEarlyAreWholePieces) {
  Case mill = example_case();
  mill.liner.sector.rows = 40;
  mill.dem.mix_revolutions = 0.41;  // 16.4 pitches
  EXPECT_EQ(mixing_steps(mill, plan).total(), 17 * 1250);
  mill.dem.mix_until_steady = true;
  EXPECT_EQ(mixing_steps(mill, plan).total(), 18 * 1250);
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

// A revolution is 12 pitches in 10 blocks: 6 pitches are 5 blocks. From 12 to 30 are three times 6.
TEST(StretchSteps, GoOnByWholePitchesThatAreWholeBlocks) {
  Case mill = example_case();
  mill.wear.time_blocks = 10;
  EXPECT_EQ(measuring_steps(mill, plan).go_on_steps, 0);
  mill.dem.error_target = ErrorTarget{0.05, 2.5};
  const auto steps = measuring_steps(mill, plan);
  EXPECT_EQ(steps.measure_steps, 12 * 1250);
  EXPECT_EQ(steps.go_on_steps, 6 * 1250);
  EXPECT_EQ(steps.most_measure_steps, 30 * 1250);
  mill.dem.error_target->most_revolutions = 1.0;
  EXPECT_EQ(measuring_steps(mill, plan).most_measure_steps, 12 * 1250);
}

TEST(StretchSteps, AreThoseOfTheTimeThatWasMeasured) {
  const StretchSteps planned{1e-3, 500, 1000, 1, 0, 200, 1600};
  EXPECT_EQ(as_measured(planned, 1.0).total(), 1500);
  EXPECT_EQ(as_measured(planned, 1.4).total(), 1900);
  EXPECT_EQ(as_measured(planned, 1.6).samples(), 1600);
  for (const double duration : {0.8, 1.3, 1.8})
    EXPECT_THROW(static_cast<void>(as_measured(planned, duration)), ResultRejected) << duration;
  const StretchSteps fixed{1e-3, 500, 1000, 1};
  EXPECT_EQ(as_measured(fixed, 1.0).total(), 1500);
  EXPECT_THROW(static_cast<void>(as_measured(fixed, 1.2)), ResultRejected);
}

RC_GTEST_PROP(StretchSteps, GoOnUpToWhatWasAskedOrAPieceMore, ()) {
  Case mill = example_case();
  mill.liner.sector.rows = *rc::gen::inRange(3, 90);
  mill.wear.time_blocks = *rc::gen::inRange(5, 40);
  mill.dem.measure_revolutions = *rc::gen::inRange(1, 400) / 100.0;
  mill.dem.error_target =
      ErrorTarget{0.05, mill.dem.measure_revolutions * *rc::gen::inRange(100, 500) / 100.0};
  const auto steps = measuring_steps(mill, plan);
  const double asked = mill.dem.error_target->most_revolutions *
                       static_cast<double>(plan.steps_per_revolution(mill.liner.sector.rows));
  RC_ASSERT(steps.go_on_steps % plan.steps_per_pitch == 0);
  RC_ASSERT(steps.go_on_steps * mill.wear.time_blocks % steps.measure_steps == 0);
  RC_ASSERT((steps.most_measure_steps - steps.measure_steps) % steps.go_on_steps == 0);
  RC_ASSERT(static_cast<double>(steps.most_measure_steps) > asked - 1e-3);
  RC_ASSERT(static_cast<double>(steps.most_measure_steps) <
            asked + static_cast<double>(plan.steps_per_pitch + steps.go_on_steps));
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
