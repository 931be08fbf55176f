#include "mill/liner/profile_crossing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>

#include "mill/liner/liner_profile.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear {
namespace {

constexpr LinerSector sector{0.52, 0.5, 12};
using Crossing = std::pair<int, int>;

LinerProfile between_edges(std::vector<Eigen::Vector2d> middle) {
  LinerProfile profile{sector, {point_at(sector, 0.5, -0.5 * sector.pitch())}};
  profile.nodes.insert(profile.nodes.end(), middle.begin(), middle.end());
  profile.nodes.push_back(point_at(sector, 0.5, 0.5 * sector.pitch()));
  return profile;
}

TEST(FirstCrossing, SimpleProfileHasNone) {
  EXPECT_EQ(first_crossing(profile_of(sector, {0.04, 0.05, 0.3, 0.2})), Crossing(-1, -1));
}

// The two faces cross: top corners in the wrong order.
TEST(FirstCrossing, FindsFacesThatCross) {
  EXPECT_EQ(first_crossing(between_edges({{-0.02, 0.0}, {0.02, 0.04}, {-0.02, 0.04}, {0.02, 0.0}})),
            Crossing(1, 3));
}

TEST(FirstCrossing, FindsATouch) {
  EXPECT_EQ(
      first_crossing(between_edges({{-0.02, 0.01}, {0.0, 0.04}, {0.01, 0.01}, {-0.02, 0.01}})),
      Crossing(0, 3));
}

TEST(FirstCrossing, FindsASegmentRunBackOverItself) {
  EXPECT_EQ(first_crossing(between_edges({{0.0, 0.02}, {0.0, 0.06}, {0.0, 0.04}, {0.05, 0.04}})),
            Crossing(1, 2));
}

// The third node again right after itself: no crossing, whatever its segments say.
TEST(FirstCrossing, OfANodeGivenTwiceIsTold) {
  const LinerProfile twice =
      between_edges({{-0.02, 0.0}, {-0.02, 0.04}, {-0.02, 0.04}, {0.02, 0.04}, {0.02, 0.0}});
  const Crossing crossing = first_crossing(twice);
  ASSERT_EQ(crossing, Crossing(1, 3));
  EXPECT_EQ(node_given_twice(twice, crossing), Crossing(2, 3));
  EXPECT_EQ(first_repeated_node(twice.nodes), 3U);
  const LinerProfile crossed =
      between_edges({{-0.02, 0.0}, {0.02, 0.04}, {-0.02, 0.04}, {0.02, 0.0}});
  EXPECT_FALSE(node_given_twice(crossed, first_crossing(crossed)));
  EXPECT_FALSE(first_repeated_node(crossed.nodes));
}

// A hook that leans far over the next lifter: only its neighbour is crossed, not itself.
TEST(FirstCrossing, FindsTheNextLifter) {
  const LinerProfile hook = between_edges(
      {{-0.05, 0.01}, {-0.02, 0.09}, {0.24, 0.10}, {0.24, 0.09}, {0.0, 0.08}, {0.02, 0.01}});
  const auto [first, second] = first_crossing(hook);
  EXPECT_GE(first, 0);
  EXPECT_GE(second, 0);
}

RC_GTEST_PROP(FirstCrossing, StarShapedProfilesAreSimple, ()) {
  std::vector<Eigen::Vector2d> middle;
  for (int i = 1; i < 40; ++i) {
    const double radius = 0.3 + *rc::gen::inRange(0, 200) * 1e-3;
    middle.push_back(point_at(sector, radius, sector.pitch() * (i / 40.0 - 0.5)));
  }
  RC_ASSERT(first_crossing(between_edges(middle)) == Crossing(-1, -1));
}

// a, b, c, d on an arc taken as a, c, b, d: the diagonals of a convex quadrangle cross.
RC_GTEST_PROP(FirstCrossing, TwoNodesOfAnArcSwappedAreSeen, ()) {
  std::vector<Eigen::Vector2d> middle;
  for (int i = 1; i < 40; ++i) {
    middle.push_back(point_at(sector, 0.45, sector.pitch() * (i / 40.0 - 0.5)));
  }
  const auto at = static_cast<std::size_t>(*rc::gen::inRange(1, 36));
  std::swap(middle[at], middle[at + 1]);
  const int first = static_cast<int>(at);
  RC_ASSERT(first_crossing(between_edges(middle)) == Crossing(first, first + 2));
}

TEST(FirstCrossing, TakesTwoThousandNodes) {
  std::vector<Eigen::Vector2d> middle;
  for (int i = 1; i < 2000; ++i) {
    middle.push_back(
        point_at(sector, 0.45 + 0.02 * std::sin(i * 0.05), sector.pitch() * (i / 2000.0 - 0.5)));
  }
  const LinerProfile profile = between_edges(middle);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(first_crossing(profile), Crossing(-1, -1));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace millwear
