#include "orchestrator/results/load_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace millwear::orchestrator {
namespace {

Conservation cycle_with(int cycle, double path) {
  Conservation balance{};
  balance.cycle = cycle;
  balance.path_over_slip = path;
  return balance;
}

TEST(ShakingWarning, IsOfTheCycleInWhichParticlesShookMost) {
  const auto warning = shaking_warning(
      {cycle_with(0, std::nan("")), cycle_with(1, 1.8), cycle_with(2, 2.71), cycle_with(3, 1.1)});
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, testing::StartsWith("cycle 2:"));
  EXPECT_THAT(*warning, testing::HasSubstr("2.7 times"));
  EXPECT_THAT(*warning, testing::HasSubstr("`rayleigh_fraction`"));
}

TEST(ShakingWarning, IsSilentWhereTheStepResolvesTheContactsOrNothingIsKnown) {
  EXPECT_FALSE(shaking_warning({cycle_with(0, 1.0), cycle_with(1, longest_path_over_slip)}));
  EXPECT_FALSE(shaking_warning({cycle_with(0, std::nan(""))}));
  EXPECT_FALSE(shaking_warning({}));
}

Conservation cycle_of_scatter(int cycle, double scatter) {
  Conservation balance{};
  balance.cycle = cycle;
  balance.load_scatter = scatter;
  return balance;
}

TEST(JumpingWarning, IsOfTheCycleAboutWhichLoadsJumpMost) {
  const auto warning = jumping_warning(
      {cycle_of_scatter(0, 1.2), cycle_of_scatter(1, 4.2), cycle_of_scatter(2, 3.1)});
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, testing::StartsWith("cycle 1: the loads about it jump 4.2 times"));
}

TEST(JumpingWarning, IsSilentOfNoise) {
  EXPECT_FALSE(
      jumping_warning({cycle_of_scatter(0, 1.0), cycle_of_scatter(1, largest_load_scatter)}));
  EXPECT_FALSE(jumping_warning({}));
}

}  // namespace
}  // namespace millwear::orchestrator
