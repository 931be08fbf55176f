#include "orchestrator/stretch/stretch_progress.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace millwear::orchestrator {
namespace {

bool at_step(StretchProgress& progress, long step) {
  return progress.take(fmt::format("{:8} 120 0.5 0.1 -3.2", step));
}

TEST(StretchProgress, FollowsTheStepsOfAMeasurementOfGivenLength) {
  StretchProgress progress({1e-5, 1000, 3000, 1});
  EXPECT_FALSE(progress.take("Step Atoms kinetic spinning torque"));
  EXPECT_EQ(progress.done(), 0.0);
  EXPECT_TRUE(at_step(progress, 1000));
  EXPECT_DOUBLE_EQ(progress.done(), 0.25);
  at_step(progress, 4000);
  EXPECT_DOUBLE_EQ(progress.done(), 1.0);
  EXPECT_FALSE(progress.goes_on());
}

// 1,000 + 3,000 steps, up to 1,000 + 9,000: taken to end at 7,000. At 4,000 it is told 8,000, and
// at 6,000 that it will be 10,000: each time what is left is shared out anew.
TEST(StretchProgress, NeverGoesBackwardsWhileAMeasurementGoesOn) {
  StretchProgress progress({1e-5, 1000, 3000, 1, 0, 1000, 9000});
  at_step(progress, 4000);
  EXPECT_DOUBLE_EQ(progress.done(), 4.0 / 7.0);
  progress.take(
      "millwear: step 4000, rate at its peaks known to 7.1 % (target 5 %), going on to step 5000, "
      "perhaps to 8000");
  EXPECT_TRUE(progress.goes_on());
  EXPECT_DOUBLE_EQ(progress.done(), 4.0 / 7.0);
  at_step(progress, 4000);
  EXPECT_DOUBLE_EQ(progress.done(), 4.0 / 7.0);
  at_step(progress, 6000);
  EXPECT_DOUBLE_EQ(progress.done(), 4.0 / 7.0 + 3.0 / 7.0 * 0.5);
  progress.take(
      "millwear: step 6000, rate at its peaks known to 6 % (target 5 %), going on to step 7000, "
      "perhaps to 10000");
  at_step(progress, 6000);
  EXPECT_DOUBLE_EQ(progress.done(), 4.0 / 7.0 + 3.0 / 7.0 * 0.5);
  at_step(progress, 10000);
  EXPECT_DOUBLE_EQ(progress.done(), 1.0);
}

}  // namespace
}  // namespace millwear::orchestrator
