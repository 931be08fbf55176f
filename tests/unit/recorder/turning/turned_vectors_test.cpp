#include "recorder/turning/turned_vectors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;

Quaternion quaternion(double angle, const Vector3d& axis) {
  const Vector3d along = std::sin(0.5 * angle) * axis.normalized();
  return {std::cos(0.5 * angle), along.x(), along.y(), along.z()};
}

std::vector<double> random_vectors(std::size_t count) {
  std::mt19937 random(20060211);
  std::uniform_real_distribution<double> between(-2.0, 2.0);
  std::vector<double> values(3 * count);
  for (auto& value : values) value = between(random);
  return values;
}

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

/// A product that is rounded before it is added to another.
double rounded(double a, double b) {
  volatile const double product = a * b;
  return product;
}

/// As `MathExtra::quatquat` of LIGGGHTS 3.8 writes it.
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const auto p = [&](std::size_t i, std::size_t j) { return rounded(a[i], b[j]); };
  return {p(0, 0) - p(1, 1) - p(2, 2) - p(3, 3), p(0, 1) + p(1, 0) + p(2, 3) - p(3, 2),
          p(0, 2) + p(2, 0) + p(3, 1) - p(1, 3), p(0, 3) + p(3, 0) + p(1, 2) - p(2, 1)};
}

// Turning about +y takes +x to -z.
TEST(TurnedVectors, GoARightAngleAboutTheMillsAxis) {
  std::vector<double> directions = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0};
  turn_directions(directions, quaternion(0.5 * std::numbers::pi, Vector3d::UnitY()));
  const std::vector<double> expected = {0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(directions[i], expected[i], 1e-15) << i;
}

// With zeros of either sign too: edges along the axis have them.
TEST(TurnedVectors, HaveTheBitsOfLiggghtssExpressionsHoweverManyTheyAre) {
  for (const auto& axis : {Vector3d(0.0, 1.0, 0.0), Vector3d(0.3, -0.8, 0.5)}) {
    const Quaternion q = quaternion(1.7e-4, axis);
    for (std::size_t count = 0; count <= 35; ++count) {
      auto directions = random_vectors(count);
      for (std::size_t n = 0; n < count; n += 3) directions[3 * n] = directions[3 * n + 2] = 0.0;
      for (std::size_t n = 1; n < count; n += 3) directions[3 * n] = -0.0;
      std::vector<double> expected;
      for (std::size_t n = 0; n < count; ++n) {
        const double* const v = &directions[3 * n];
        const auto half = product(q, {0.0, v[0], v[1], v[2]});
        const auto whole = product(half, {q[0], -q[1], -q[2], -q[3]});
        expected.insert(expected.end(), whole.begin() + 1, whole.end());
      }
      turn_directions(directions, q);
      EXPECT_EQ(bits_of(directions), bits_of(expected)) << count;
    }
  }
}

TEST(TurnedVectors, OfPointsTurnAboutTheirCentre) {
  const Vector3d axis = Vector3d(1.0, 2.0, -1.0).normalized();
  const Vector3d centre(0.4, -1.0, 2.0);
  const double angle = 0.3;
  const Eigen::AngleAxisd turn(angle, axis);
  for (const std::size_t count : {1, 4, 9, 30}) {
    const auto before = random_vectors(count);
    auto points = before;
    turn_points(points, {quaternion(angle, axis), {centre.x(), centre.y(), centre.z()}});
    for (std::size_t n = 0; n < count; ++n) {
      const Vector3d expected = centre + turn * (Vector3d(&before[3 * n]) - centre);
      EXPECT_NEAR((Vector3d(&points[3 * n]) - expected).norm(), 0.0, 1e-14);
    }
  }
}

// LIGGGHTS takes away and adds no centre that is the origin; adding 0 would turn -0 into 0.
TEST(TurnedVectors, OfPointsAboutTheOriginKeepTheSignOfAZero) {
  const Quaternion q = quaternion(1e-4, -Vector3d::UnitY());
  const auto before = std::vector<double>{-0.0, -1.0, -0.0, -0.0, 1.0, 0.0};
  auto points = before;
  auto directions = before;
  turn_points(points, {q, {0.0, 0.0, 0.0}});
  turn_directions(directions, q);
  EXPECT_EQ(bits_of(points), bits_of(directions));
}

TEST(TurnedVectors, CentresAreTheMeansOfThreeCorners) {
  for (const std::size_t count : {1, 4, 11}) {
    const auto corners = random_vectors(3 * count);
    std::vector<double> centres(3 * count);
    find_centres(corners, centres);
    for (std::size_t n = 0; n < 3 * count; ++n) {
      const double* const first = &corners[9 * (n / 3) + n % 3];
      EXPECT_EQ(centres[n], 1.0 / 3.0 * (first[6] + (first[3] + first[0]))) << n;
    }
  }
}

// At 2 rad/s about +y through (1, 0, 0), a point 3 m beyond it along x goes down by 6 m/s.
TEST(TurnedVectors, VelocitiesAreThoseOfTheTurn) {
  const std::vector<double> points = {4.0, 7.0, 0.0, 1.0, 5.0, 0.5};
  std::vector<double> velocities(6, 1e9);
  find_velocities(points, {{0.0, 2.0, 0.0}, {1.0, 0.0, 0.0}}, velocities);
  EXPECT_EQ(velocities, (std::vector<double>{0.0, 0.0, -6.0, 1.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace millwear::recorder
