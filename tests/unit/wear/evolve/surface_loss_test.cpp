#include "wear/evolve/surface_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double rate = 1e-9;  // of a flat surface [m/s]
constexpr Eigen::Index bins = 300;

/// A load that wears every flat surface alike.
LoadInTime even_load(const LinerProfile& liner, const RollingBalls& balls) {
  const Eigen::VectorXd even = Eigen::VectorXd::Constant(bins, rate);
  const Eigen::VectorXd path = centre_path(liner, bins, balls);
  const Eigen::VectorXd edges =
      Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(liner).back());
  const std::vector<TimedLoad> loads = {
      {0.0, liner, {edges, path * rate}, {}, Rolling{path, even, balls}}};
  return LoadInTime(loads);
}

/// Flat but for a ripple of `amplitude` and `waves` along the pitch of a mill of 100 m, in which
/// 400 rows make a pitch of 1.57 m nearly straight.
LinerProfile rippled(double amplitude, int waves) {
  const LinerSector sector{101.0, 100.0, 400};
  LinerProfile profile{sector, {}};
  constexpr int nodes = 3000;
  for (int i = 0; i <= nodes; ++i) {
    const double share = static_cast<double>(i) / nodes;
    profile.nodes.push_back(
        point_at(sector, 100.0 - amplitude * std::cos(2.0 * std::numbers::pi * waves * share),
                 sector.pitch() * (share - 0.5)));
  }
  return profile;
}

// On a surface of curvature kappa the centre's way is 1 + r kappa: the amplitude of a ripple of
// wave number k decays by f r k^2 a.
TEST(SurfaceLoss, WearsCrestsAndSparesHollows) {
  const double amplitude = 1e-4;
  const int waves = 20;
  const auto liner = rippled(amplitude, waves);
  const double length = arc_lengths(liner).back();
  const double wave_number = 2.0 * std::numbers::pi * waves / length;
  const RollingBalls balls{0.0, 0.02};
  const double duration = 100.0;
  const auto nodes = depths_after(surface_loss(liner, even_load(liner, balls), 0.0), duration);
  const double expected = rate * duration * balls.mean * wave_number * wave_number * amplitude;
  double crest = 0.0;
  double hollow = 1.0;
  for (const auto& node : nodes) {
    crest = std::max(crest, node.depth);
    hollow = std::min(hollow, node.depth);
  }
  EXPECT_NEAR(0.5 * (crest - hollow), expected, 0.01 * expected);
  const double concave = 1.0 - balls.mean / 100.0;
  EXPECT_NEAR(0.5 * (crest + hollow), rate * duration * concave, 0.002 * rate * duration);
}

// However long the step, the ripple is levelled and not turned over.
TEST(SurfaceLoss, LevelsInAnyStep) {
  const double amplitude = 1e-4;
  const auto liner = rippled(amplitude, 40);
  const RollingBalls balls{0.0, 0.02};
  const auto nodes = depths_after(surface_loss(liner, even_load(liner, balls), 0.0), 1e9);
  double crest = 0.0;
  double hollow = 1e9;
  for (const auto& node : nodes) {
    crest = std::max(crest, node.depth);
    hollow = std::min(hollow, node.depth);
  }
  EXPECT_GT(crest - hollow, 1.9 * amplitude);
  EXPECT_LT(crest - hollow, 2.1 * amplitude);
}

// An edge of angle a takes r a more than its faces; what spreads from it stays its own.
TEST(SurfaceLoss, OfAnEdgeIsTheWayAboutIt) {
  const auto liner = square_lifter();
  const RollingBalls points{0.0, 0.0};
  const RollingBalls balls{0.02, 0.02};
  const double flat = section_rate(surface_loss(liner, even_load(liner, points), 0.0));
  const auto loss = surface_loss(liner, even_load(liner, balls), 0.0);
  const double edges = 2.0 * std::numbers::pi / 2.0 * balls.mean * rate;
  const double plate = 0.1 * rate;  // what its kinks and the feet's arcs change, at most
  EXPECT_NEAR(section_rate(loss), flat + edges, plate);
  const double duration = 1e5;
  EXPECT_NEAR(loss_area(depths_after(loss, duration)), duration * section_rate(loss),
              0.02 * duration * edges);
}

// Corrosion knows no balls.
TEST(SurfaceLoss, OfCorrosionIsTheSameEverywhere) {
  const auto liner = square_lifter();
  const RollingBalls balls{0.02, 0.02};
  SurfaceLoss loss = surface_loss(liner, even_load(liner, balls), 0.0);
  for (auto& node : loss.nodes) node.depth = 0.0;
  loss.corrosion = 3e-10;
  for (const auto& node : depths_after(loss, 100.0)) EXPECT_NEAR(node.depth, 3e-8, 1e-20);
}

}  // namespace
}  // namespace millwear::wear
