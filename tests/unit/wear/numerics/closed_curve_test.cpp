#include "wear/numerics/closed_curve.h"

#include <gmock/gmock.h>

namespace millwear::wear {
namespace {

using testing::DoubleNear;
using testing::Optional;

Eigen::VectorXd values_of(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(), std::ssize(values));
}

TEST(ClosedCurve, GoesAroundBothWays) {
  EXPECT_EQ(around(7, 5), 2);
  EXPECT_EQ(around(-1, 5), 4);
  EXPECT_EQ(around(-11, 5), 4);
}

TEST(ClosedCurve, IsSmoothedOverItsEnds) {
  const Eigen::VectorXd means = running_mean(values_of({3.0, 0.0, 0.0, 0.0}), 1);
  EXPECT_DOUBLE_EQ(means[0], 1.0);
  EXPECT_DOUBLE_EQ(means[1], 1.0);
  EXPECT_DOUBLE_EQ(means[2], 0.0);
  EXPECT_DOUBLE_EQ(means[3], 1.0);
}

TEST(ClosedCurve, HasThePercentileThatAShareIsNotAbove) {
  EXPECT_EQ(percentile(values_of({5.0, 1.0, 3.0, 2.0, 4.0}), 0.5), 3.0);
  EXPECT_EQ(percentile(values_of({5.0, 1.0, 3.0, 2.0, 4.0}), 1.0), 5.0);
}

// From 8 over 6 to 2 the line falls through 5 a quarter of a step behind the second value; the
// other way over the end of the values 8, 4 falls through it three quarters of a step on.
TEST(ClosedCurve, FallsThroughALevelToAPartOfAStep) {
  const Eigen::VectorXd values = values_of({8.0, 6.0, 2.0, 2.0, 4.0});
  EXPECT_THAT(steps_until_below(values, 5.0, 0, 1), Optional(DoubleNear(1.25, 1e-12)));
  EXPECT_THAT(steps_until_below(values, 5.0, 0, -1), Optional(DoubleNear(0.75, 1e-12)));
  EXPECT_EQ(steps_until_below(values, 1.0, 0, 1), std::nullopt);
}

}  // namespace
}  // namespace millwear::wear
