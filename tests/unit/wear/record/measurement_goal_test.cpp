#include "wear/record/measurement_goal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TEST(MeasurementGoal, IsReachedAtTheTargetAndBelowButNotWhereNothingIsKnown) {
  EXPECT_TRUE(is_reached({0.05, 0.04}));
  EXPECT_TRUE(is_reached({0.05, 0.05}));
  EXPECT_FALSE(is_reached({0.05, 0.0500001}));
  EXPECT_FALSE(is_reached({0.05, unknown}));
}

// 7 % after half a revolution are 5 % after 0.5 (7/5)^2 = 0.98 revolutions.
TEST(MeasurementGoal, TellsHowLongItWillTake) {
  EXPECT_NEAR(length_to_reach({0.05, 0.07}, 0.5), 0.98, 1e-12);
  EXPECT_TRUE(std::isinf(length_to_reach({0.05, unknown}, 0.5)));
}

}  // namespace
}  // namespace millwear::wear
