#include "wear/surface/centre_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr RollingBalls points{0.0, 0.0};
constexpr RollingBalls balls{0.02, 0.03};
constexpr Eigen::Index bins = 100;

TEST(CentrePath, OfPointsIsTheSurface) {
  EXPECT_TRUE((centre_path(square_lifter(), bins, points).array() == 1.0).all());
}

// A hollow ring of radius R shortens the way by 1 - r / R.
TEST(CentrePath, InARingIsShorter) {
  const auto ring = bare_ring(1.0, 400);
  const Eigen::VectorXd path = centre_path(ring, bins, balls);
  EXPECT_NEAR(path.mean(), 1.0 - balls.mean / 1.0, 1e-4);
}

// About an edge of 90 degrees the centre goes r pi / 2; a foot lies in the shadow of the ball.
TEST(CentrePath, TurnsAboutEdgesAndLeavesFeetOut) {
  const auto lifter = square_lifter();
  const auto lengths = arc_lengths(lifter);
  const double width = lengths.back() / bins;
  const Eigen::VectorXd path = centre_path(lifter, bins, balls);
  const auto bin_at = [&](double s) { return static_cast<Eigen::Index>(s / width); };
  const double about_edge = 1.0 + balls.mean * std::numbers::pi / 2.0 / width;
  EXPECT_NEAR(path[bin_at(lengths[3])], about_edge, 1e-9);
  EXPECT_NEAR(path[bin_at(lengths[4])], about_edge, 1e-9);
  for (const double foot : {lengths[2], lengths[5]}) {
    EXPECT_EQ(path[bin_at(foot - 0.5 * balls.smallest)], 0.0);
    EXPECT_EQ(path[bin_at(foot + 0.5 * balls.smallest)], 0.0);
  }
  EXPECT_EQ(path[bin_at(0.5 * (lengths[2] + lengths[3]))], 1.0);
}

}  // namespace
}  // namespace millwear::wear
