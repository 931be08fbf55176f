#include "wear/numerics/paper_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace millwear::wear {
namespace {

Eigen::VectorXd wave(Eigen::Index bins, int number) {
  const double step = 2.0 * std::numbers::pi * number / static_cast<double>(bins);
  return Eigen::VectorXd::NullaryExpr(
      bins, [&](auto bin) { return std::cos(step * (static_cast<double>(bin) + 0.5)); });
}

// The sum over the pitch is kept to a rounding of the curve to bins, even before any scaling.
TEST(PaperSpline, KeepsConstantsAndNearlyAllOfTheSum) {
  const auto smoother = paper_spline(120);
  EXPECT_LT((smoother.hat.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-10);
  EXPECT_LT((smoother.hat.colwise().sum().array() - 1.0).abs().maxCoeff(), 1e-3);
}

// 32 break points hold waves to 16 periods in the limit: four are kept, forty are gone.
TEST(PaperSpline, KeepsBroadWavesAndLosesNarrowOnes) {
  const auto smoother = paper_spline(120);
  EXPECT_LT((smoother.hat * wave(120, 4) - wave(120, 4)).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_LT((smoother.hat * wave(120, 40)).lpNorm<Eigen::Infinity>(), 0.05);
}

// As many degrees of freedom as break points: the trace of a projection, here of one that is
// evaluated between the places of its least squares.
TEST(PaperSpline, HasAsManyDegreesOfFreedomAsBreakPoints) {
  EXPECT_NEAR(paper_spline(200).hat.trace(), 32.0, 0.5);
  EXPECT_NEAR(paper_spline(40).hat.trace(), 20.0, 0.5);
}

}  // namespace
}  // namespace millwear::wear
