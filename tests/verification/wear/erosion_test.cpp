#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "wear/evolve/evolution.h"
#include "wear/evolve/profile_motion.h"

namespace millwear::wear {
namespace {

using std::numbers::pi;

double even(double) { return 1.0; }

// A ring worn evenly stays a ring: the annulus sector pitch / 2 ((R + d)^2 - R^2) is d deep. Its
// 400 facets lie within R (pitch / 400)^2 / 8 = 0.3 um of the circle.
TEST(Erosion, OfABareRingIsAnAnnulus) {
  const auto ring = bare_ring(1.0, 400);
  const double depth = 2e-3;
  const double area = 0.5 * sample_sector.pitch() * (std::pow(1.0 + depth, 2) - 1.0);
  const auto worn = move_profile(ring, loss_nodes(ring, 0.004, even), area, 0.004);
  EXPECT_NEAR(worn.removed_area, area, 1e-9 * area);
  for (const auto& node : worn.profile.nodes) {
    EXPECT_NEAR(radius_of(sample_sector, node), 1.0 + depth, 2e-6);
  }
}

// A flat plate meets the next one at the sector's edge, under the angle of the pitch; a disc of
// radius d takes L d and there the sector d^2 pitch / 2, which its 15 degree facets miss by 1 %.
TEST(Erosion, OfAFlatPlateLowersItEvenly) {
  const double half = 0.5 * sample_sector.pitch();
  const Eigen::Vector2d end = point_at(sample_sector, 1.0, half);
  const LinerProfile plate{sample_sector,
                           {point_at(sample_sector, 1.0, -half), {0.0, end.y()}, end}};
  const double depth = 1e-3;
  const double area = 2.0 * end.x() * depth + depth * depth * half;
  const auto worn = move_profile(plate, loss_nodes(plate, 0.004, even), area, 0.004);
  for (const auto& node : worn.profile.nodes) {
    if (std::abs(node.x()) < end.x() - depth) {
      EXPECT_NEAR(node.y(), end.y() - depth, 2e-8);
    }
  }
}

/// Area that a disc of radius `depth` takes off: L d + d^2 (sum of half angles of the feet minus
/// sum of tan of half angles of the corners).
double minkowski_area(const LinerProfile& profile, double depth) {
  auto nodes = profile.nodes;
  nodes.push_back(shifted_by_pitches(profile.sector, nodes[1], 1));
  double area = depth * arc_lengths(profile).back();
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d a = nodes[i] - nodes[i - 1];
    const Eigen::Vector2d b = nodes[i + 1] - nodes[i];
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    area += depth * depth * (turn > 0.0 ? 0.5 * turn : -std::tan(-0.5 * turn));
  }
  return area;
}

// The fans at the feet are polygons of 15 degree steps, 1.1 % short of the disc's area: at 2 mm
// 8e-8 of 1.6e-3 m2.
TEST(Erosion, OfASquareLifterIsMinkowskis) {
  const auto profile = square_lifter();
  const double depth = 2e-3;
  const double area = minkowski_area(profile, depth);
  auto nodes = loss_nodes(profile, 0.004, even);
  nodes = scaled(nodes, depth);
  const auto worn = move_profile(profile, nodes, area, 0.004);
  EXPECT_NEAR(worn.depth_scale, 1.0, 1e-4);
  const auto has = [&](double xi, double eta) {
    return std::any_of(worn.profile.nodes.begin(), worn.profile.nodes.end(),
                       [&](const auto& p) { return (p - Eigen::Vector2d(xi, eta)).norm() < 5e-7; });
  };
  EXPECT_TRUE(has(-0.048, 0.098));
  EXPECT_TRUE(has(0.048, 0.098));
  EXPECT_TRUE(has(0.05, -0.002));
  EXPECT_TRUE(has(-0.05, -0.002));
}

TEST(Erosion, KeepsItsAccountOverFiftyRandomSteps) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  LinerProfile profile = square_lifter();
  const double lifter = lifter_area(profile);
  for (int step = 0; step < 50; ++step) {
    const double length = arc_lengths(profile).back();
    ArcCurve curve{Eigen::VectorXd::LinSpaced(151, 0.0, length), Eigen::VectorXd(150)};
    for (double& rate : curve.values) rate = std::max(0.0, value(random) - 0.3);
    const auto nodes =
        loss_nodes(profile, curve.bin_width(), [&](double s) { return curve.at(s); });
    const double target = 0.01 * lifter * (0.1 + value(random));
    const auto worn = move_profile(profile, nodes, target, curve.bin_width());
    EXPECT_NEAR(steel_area(profile) - steel_area(worn.profile), target, 1e-9 * target);
    profile = worn.profile;
  }
}

// 120 steps under a load with a peak on the leading corner and noise from bin to bin.
TEST(Erosion, KeepsTheNumberOfNodesBounded) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(1.0, 0.1);
  LinerProfile profile = square_lifter();
  const double lifter = lifter_area(profile);
  std::size_t most_nodes = 0;
  for (int step = 0; step < 120; ++step) {
    const double length = arc_lengths(profile).back();
    ArcCurve curve{Eigen::VectorXd::LinSpaced(151, 0.0, length), Eigen::VectorXd(150)};
    for (Eigen::Index i = 0; i < 150; ++i) {
      const double place = (static_cast<double>(i) + 0.5) / 150.0;
      curve.values[i] = noise(random) * (0.2 + std::exp(-std::pow((place - 0.6) / 0.08, 2)));
    }
    const auto nodes =
        loss_nodes(profile, curve.bin_width(), [&](double s) { return curve.at(s); });
    profile = move_profile(profile, nodes, 0.007 * lifter, curve.bin_width()).profile;
    most_nodes = std::max(most_nodes, profile.nodes.size());
  }
  RecordProperty("most_nodes", static_cast<int>(most_nodes));
  EXPECT_LT(most_nodes, 900U);
}

// A top that wears at c (1 + a xi): its tilt grows as the load follows the surface. Halving the
// step halves the difference to a run with many steps.
TEST(Erosion, ConvergesInTheStep) {
  const auto profile = square_lifter();
  const double length = arc_lengths(profile).back();
  ArcCurve curve{Eigen::VectorXd::LinSpaced(201, 0.0, length), Eigen::VectorXd(200)};
  for (Eigen::Index i = 0; i < 200; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / 200.0;
    curve.values[i] = 1e-9 * std::exp(-std::pow((place - 0.58) / 0.1, 2));
  }
  const auto height_after = [&](int steps) {
    const auto evolution = evolve(std::vector<TimedLoad>{{0.0, profile, curve}},
                                  lifter_area(profile), {0.2, steps, 0.0, 0.0, 1});
    double time = 0.0;
    for (const auto& step : evolution.steps) time += step.duration;
    return time;
  };
  const double reference = height_after(64);
  const double coarse = std::abs(height_after(4) - reference);
  const double fine = std::abs(height_after(8) - reference);
  RecordProperty("ratio", std::to_string(coarse / fine));
  EXPECT_GT(coarse / fine, 1.5);
  EXPECT_LT(coarse / reference, 0.05);
}

}  // namespace
}  // namespace millwear::wear
