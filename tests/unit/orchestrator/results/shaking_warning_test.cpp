#include "orchestrator/results/shaking_warning.h"

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

}  // namespace
}  // namespace millwear::orchestrator
