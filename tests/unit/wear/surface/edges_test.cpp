#include "wear/surface/edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double window = 0.01;
constexpr double turn = std::numbers::pi / 6.0;

TEST(Edges, OfASquareLifterAreItsCornersAndFeet) {
  const auto lifter = square_lifter();
  const auto lengths = arc_lengths(lifter);
  const auto edges = edges_of(lifter, window, turn);
  ASSERT_EQ(edges.size(), 4u);
  const double quarter = std::numbers::pi / 2.0;
  const double turns[] = {-quarter, quarter, quarter, -quarter};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(edges[i].arc_length, lengths[i + 2], 1e-12);
    EXPECT_NEAR(edges[i].turn, turns[i], 1e-12);
  }
}

TEST(Edges, OfARingAreNone) { EXPECT_TRUE(edges_of(bare_ring(), window, turn).empty()); }

/// The square lifter with its leading corner cut to an arc of `radius`.
LinerProfile rounded(double radius) {
  LinerProfile lifter = square_lifter();
  std::vector<Eigen::Vector2d> arc;
  for (int i = 0; i <= 30; ++i) {
    const double angle = std::numbers::pi / 2.0 * (1.0 - i / 30.0);
    arc.emplace_back(0.05 - radius + radius * std::cos(angle),
                     0.1 - radius + radius * std::sin(angle));
  }
  lifter.nodes.erase(lifter.nodes.begin() + 4);
  lifter.nodes.insert(lifter.nodes.begin() + 4, arc.begin(), arc.end());
  return lifter;
}

// An arc of radius R turns by window / R within the window.
TEST(Edges, VanishAsTheyWearRound) {
  const double limit = window / turn;
  EXPECT_EQ(edges_of(rounded(0.8 * limit), window, turn).size(), 4u);
  EXPECT_EQ(edges_of(rounded(1.2 * limit), window, turn).size(), 3u);
  const auto edges = edges_of(rounded(0.3 * limit), window, turn);
  const auto corner =
      arc_lengths(square_lifter())[4] - 0.3 * limit * (1.0 - std::numbers::pi / 4.0);
  EXPECT_NEAR(edges[2].arc_length, corner, 0.15 * limit);
}

// A hollow ring of radius R, on chords of a twentieth of it.
TEST(Curvature, OfAHollowRingIsNegative) {
  const auto ring = bare_ring(1.0, 400);
  const Eigen::VectorXd curvature = curvature_along(ring, 50, 0.05);
  EXPECT_NEAR(curvature.mean(), -1.0, 1e-3);
  EXPECT_NEAR(curvature.maxCoeff(), -1.0, 0.02);
}

TEST(Edges, TakeAWindowAndATurn) {
  EXPECT_THROW(static_cast<void>(edges_of(bare_ring(), 0.0, turn)), std::logic_error);
  EXPECT_THROW(static_cast<void>(edges_of(bare_ring(), window, 0.0)), std::logic_error);
}

}  // namespace
}  // namespace millwear::wear
