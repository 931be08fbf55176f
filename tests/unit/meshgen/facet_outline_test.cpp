#include "meshgen/facet_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using test::bare_plate;
using test::degree;
using ::testing::HasSubstr;

double distance_to(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point) {
  double nearest = INFINITY;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d chord = line[i] - line[i - 1];
    const double along =
        std::clamp((point - line[i - 1]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - line[i - 1] - along * chord).norm());
  }
  return nearest;
}

double largest_distance(const std::vector<Eigen::Vector2d>& from,
                        const std::vector<Eigen::Vector2d>& to) {
  double largest = 0.0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    for (int part = 0; part <= 20; ++part) {
      const double share = part / 20.0;
      largest = std::max(largest, distance_to(to, from[i - 1] * (1.0 - share) + from[i] * share));
    }
  }
  return largest;
}

std::string refusal_of(const LinerProfile& profile, double tolerance) {
  try {
    static_cast<void>(dem_outline(profile, tolerance));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A chord over the angle a lies R (1 - cos(a/2)) from its arc: on R = 1 m a tolerance of 1 mm
// allows a = 2 acos(0.999) = 5.124 degrees, so the pitch of 30 degrees takes ceil(5.855) = 6
// facets.
TEST(DemOutline, CutsAnArcIntoAsManyFacetsAsItsSagittaAllows) {
  const auto plate = bare_plate(1.0, 12, 300);
  const auto outline = dem_outline(plate, 1e-3);
  EXPECT_EQ(outline.size() - 1, 6u);
  const auto lengths = facet_lengths(outline);
  for (const double length : lengths) {
    EXPECT_NEAR(length, 2.0 * std::sin(2.5 * degree), 1e-6);
  }
}

TEST(DemOutline, KeepsEveryCornerOfATrapezoidOnAStraightPlate) {
  const auto profile = profile_of({0.52, 0.50, 12}, {0.040, 0.030, 20.0 * degree, 20.0 * degree},
                                  PlateShape::straight);
  EXPECT_EQ(dem_outline(profile, 0.45e-3), profile.nodes);
}

// The plate between two laboratory lifters spans about 23 degrees: 2 acos(1 - 0.45/500) = 4.86
// degrees a facet make 5 of it; its nodes lie where the profile has them, which costs one more.
TEST(DemOutline, LaboratoryLinerTakesFewFacets) {
  const auto outline = dem_outline(test::laboratory_liner(), 0.45e-3);
  EXPECT_LE(outline.size() - 1, 3u + 6u);
  EXPECT_GE(outline.size() - 1, 3u + 5u);
}

TEST(DemOutline, StaysWithinTheToleranceBothWays) {
  for (const double tolerance : {0.1e-3, 0.33e-3, 1e-3, 5e-3}) {
    for (const auto& profile :
         {test::laboratory_liner(), test::production_liner(), bare_plate(1.0, 12, 300)}) {
      const auto outline = dem_outline(profile, tolerance);
      EXPECT_LE(largest_distance(outline, profile.nodes), tolerance);
      EXPECT_LE(largest_distance(profile.nodes, outline), tolerance);
      EXPECT_EQ(outline.front(), profile.nodes.front());
      EXPECT_EQ(outline.back(), profile.nodes.back());
    }
  }
}

// Start, hollow (1, 0), nose (1.1, 0.1), end. One facet passes the nose by 0.28 m. Two facets
// through the nose stand out over the hollow by 0.128 m (0.136 cos 20 degrees); two through the
// hollow cut the nose off by 0.141 m (0.182 cos 39 degrees): farther, but into steel.
TEST(DemOutline, RatherCutsIntoSteelThanStandsOut) {
  const LinerProfile profile{{110.0, 100.0, 6}, {{0.0, 0.5}, {1.0, 0.0}, {1.1, 0.1}, {2.1, -0.9}}};
  const auto outline = dem_outline(profile, 0.15);
  ASSERT_EQ(outline.size(), 3u);
  EXPECT_EQ(outline[1], profile.nodes[1]);
}

TEST(DemOutline, RefusesAProfileThatCrossesItself) {
  auto profile = test::laboratory_liner();
  std::swap(profile.nodes[profile.nodes.size() / 2 - 1], profile.nodes[profile.nodes.size() / 2]);
  EXPECT_THAT(refusal_of(profile, 0.45e-3), HasSubstr("the liner profile crosses itself: segment"));
}

TEST(DemOutline, RefusesAToleranceOfNothing) {
  EXPECT_THROW(static_cast<void>(dem_outline(test::laboratory_liner(), 0.0)), std::logic_error);
  EXPECT_THROW(static_cast<void>(dem_outline(test::laboratory_liner(), NAN)), std::logic_error);
}

TEST(WithFacetsBelow, CutsLongFacetsEvenly) {
  const auto outline = with_facets_below({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.2}}, 0.4);
  const std::vector<Eigen::Vector2d> expected = {
      {0.0, 0.0}, {1.0 / 3.0, 0.0}, {2.0 / 3.0, 0.0}, {1.0, 0.0}, {1.0, 0.2}};
  ASSERT_EQ(outline.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(outline[i].isApprox(expected[i], 1e-15)) << i;
  }
}

}  // namespace
}  // namespace millwear::meshgen
