#include "recorder/walls/triangle_reach.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;

using Triangle = std::array<Vector3d, 3>;

/// 3 m along x, 4 m along y.
const Triangle right_angled = {Vector3d(0.0, 0.0, 0.0), Vector3d(3.0, 0.0, 0.0),
                               Vector3d(0.0, 4.0, 0.0)};

TrianglePlanes planes_around(const Triangle& corners) {
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  std::array<Vector3d, 3> edges;
  for (std::size_t k = 0; k < 3; ++k)
    edges[k] = (corners[(k + 1) % 3] - corners[k]).cross(normal).normalized();
  return planes_of(corners[0].data(), normal.data(), edges[0].data());
}

struct Ball {
  Vector3d centre;
  double radius;
};

std::vector<int> near(const Triangle& triangle, const std::vector<Ball>& balls) {
  std::vector<double> centres, radii;
  for (const auto& ball : balls) {
    centres.insert(centres.end(), ball.centre.begin(), ball.centre.end());
    radii.push_back(ball.radius);
  }
  std::vector<int> all(balls.size()), found(balls.size());
  std::iota(all.begin(), all.end(), 0);
  found.resize(
      find_within_reach(planes_around(triangle), {centres.data(), radii.data()}, all, found));
  return found;
}

TEST(TriangleReach, EndsARadiusFromThePlaneOnBothSides) {
  EXPECT_EQ(near(right_angled, {{{1.0, 1.0, 0.5}, 0.5},
                                {{1.0, 1.0, 0.51}, 0.5},
                                {{1.0, 1.0, -0.5}, 0.5},
                                {{1.0, 1.0, -0.51}, 0.5}}),
            (std::vector<int>{0, 2}));
}

// The long edge is 2.4 m from the corner at the origin, along (4, 3) / 5.
TEST(TriangleReach, EndsARadiusFromEveryEdge) {
  const Vector3d across(0.8, 0.6, 0.0);
  EXPECT_EQ(near(right_angled, {{{1.0, -0.2, 0.0}, 0.2},
                                {{1.0, -0.21, 0.0}, 0.2},
                                {{-0.2, 1.0, 0.0}, 0.2},
                                {{-0.21, 1.0, 0.0}, 0.2},
                                {2.6 * across, 0.2},
                                {2.61 * across, 0.2}}),
            (std::vector<int>{0, 2, 4}));
}

TEST(TriangleReach, KeepsTheOrderOfTheCandidates) {
  const std::vector<double> centres = {1.0, 1.0, 0.0, 1.0, 1.0, 9.0, 1.0, 1.0, 0.1};
  const std::vector<double> radii = {0.5, 0.5, 0.5};
  const std::vector<int> candidates = {2, 1, 0};
  std::vector<int> found(3);
  const auto count = find_within_reach(planes_around(right_angled), {centres.data(), radii.data()},
                                       candidates, found);
  found.resize(count);
  EXPECT_EQ(found, (std::vector<int>{2, 0}));
}

double distance(const Triangle& t, const Vector3d& point) {
  const auto to_edge = [&](const Vector3d& from, const Vector3d& to) {
    const Vector3d along = to - from;
    const double part = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (from + part * along - point).norm();
  };
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k)
    inside &= (t[(k + 1) % 3] - t[k]).cross(normal).dot(point - t[k]) <= 0.0;
  if (inside) return std::abs(normal.dot(point - t[0]));
  return std::min({to_edge(t[0], t[1]), to_edge(t[1], t[2]), to_edge(t[2], t[0])});
}

TEST(TriangleReach, LeavesOutNoneThatTouches) {
  std::mt19937 random(20060211);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  const auto any = [&] { return Vector3d(between(random), between(random), between(random)); };
  std::size_t touching = 0, left_out = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Triangle triangle = {any(), any(), any()};
    std::vector<Ball> balls;
    for (int n = 0; n < 20; ++n) balls.push_back({any(), 0.2 + 0.1 * between(random)});
    const auto found = near(triangle, balls);
    left_out += balls.size() - found.size();
    for (std::size_t n = 0; n < balls.size(); ++n) {
      if (distance(triangle, balls[n].centre) > balls[n].radius) continue;
      ++touching;
      EXPECT_TRUE(std::ranges::count(found, static_cast<int>(n)) == 1);
    }
  }
  EXPECT_GT(touching, 1000U);
  EXPECT_GT(left_out, 20000U);
}

}  // namespace
}  // namespace millwear::recorder
