#include "wear/gauge/profile_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mill/base/failure.h"
#include "tests/support/sample_profiles.h"
#include "wear/evolve/signed_surface.h"

namespace millwear::wear {
namespace {

TEST(ProfileComparison, SameProfileDiffersByNothing) {
  const auto none = compare(square_lifter(), square_lifter());
  for (const double value :
       {none.lifter_height, none.face_angle, none.plate_thickness, none.signed_area,
        none.absolute_area, none.rms_distance, none.hausdorff})
    EXPECT_EQ(value, 0.0);
}

// The same places named by other nodes: nothing but rounding.
TEST(ProfileComparison, NodesOnTheLineChangeNothing) {
  LinerProfile finer = square_lifter();
  finer.nodes.insert(finer.nodes.begin() + 4, {0.013, 0.1});
  const auto none = compare(square_lifter(), finer);
  EXPECT_LT(none.rms_distance, 1e-12);
  EXPECT_LT(none.hausdorff, hausdorff_tolerance);
  EXPECT_LT(none.absolute_area, 1e-12);
}

// Rings of radius 1 and 1.01 m in facets of d = pitch/40: their polygons differ by
// 40 sin(d)/2 (1.01^2 - 1); corners lie 0.01 m apart, facets 0.01 cos(d/2).
TEST(ProfileComparison, RingsOneWithinTheOther) {
  const double facet = sample_sector.pitch() / 40;
  const auto found = compare(bare_ring(1.0), bare_ring(1.01));
  EXPECT_NEAR(found.signed_area, 20.0 * std::sin(facet) * (1.01 * 1.01 - 1.0), 1e-12);
  EXPECT_NEAR(found.absolute_area, found.signed_area, 2e-9);
  EXPECT_NEAR(found.plate_thickness, 0.01, 1e-12);
  EXPECT_NEAR(found.lifter_height, 0.01 * std::cos(0.5 * facet), 1e-12);
  EXPECT_NEAR(found.rms_distance, 0.01, 1e-6);
  EXPECT_NEAR(found.hausdorff, 0.01, 1e-12);
}

TEST(ProfileComparison, IsAMinusB) {
  const auto ab = compare(bare_ring(1.0), square_lifter());
  const auto ba = compare(square_lifter(), bare_ring(1.0));
  EXPECT_LT(ab.lifter_height, -0.09);
  EXPECT_EQ(ab.lifter_height, -ba.lifter_height);
  EXPECT_EQ(ab.signed_area, -ba.signed_area);
  EXPECT_NEAR(ab.absolute_area, ba.absolute_area, 1e-12);
  EXPECT_EQ(ab.rms_distance, ba.rms_distance);
  EXPECT_EQ(ab.hausdorff, ba.hausdorff);
}

LinerProfile narrower_lifter() {
  LinerProfile profile = square_lifter();
  profile.nodes[4] = {0.04, 0.1};
  profile.nodes[5] = {0.04, 0.0};
  return profile;
}

// The leading face worn by w = 10 mm over h = 0.1 m: w h of steel. Of a, the face lies w from b but
// within w of the foot, where it lies its height; of the top w the distance runs from 0 to w. So
// int d^2 = w^2 (h - w) + 2 w^3/3, and the same along b.
TEST(ProfileComparison, FaceWornParallel) {
  const auto wide = square_lifter();
  const auto narrow = narrower_lifter();
  const auto found = compare(wide, narrow);
  EXPECT_NEAR(found.signed_area, 1e-3, 1e-12);
  EXPECT_NEAR(found.absolute_area, 1e-3, 2e-9);
  EXPECT_NEAR(found.face_angle, 0.0, 1e-9);
  EXPECT_NEAR(found.lifter_height, 0.0, 1e-12);
  EXPECT_NEAR(found.hausdorff, 0.01, hausdorff_tolerance);
  const double square = 1e-4 * 0.09 + 2.0 / 3.0 * 1e-6;
  const double mean =
      0.5 * (square / arc_lengths(wide).back() + square / arc_lengths(narrow).back());
  EXPECT_NEAR(found.rms_distance, std::sqrt(mean), 2e-6);
}

// A face that leans by 0.02 in 0.1 m.
TEST(ProfileComparison, FaceThatLeans) {
  LinerProfile leaning = square_lifter();
  leaning.nodes[4].x() -= 0.02;
  const auto found = compare(leaning, square_lifter());
  EXPECT_NEAR(found.face_angle, std::atan(0.2), 1e-3);
  EXPECT_NEAR(found.signed_area, -1e-3, 1e-12);
}

// A lifter 10 mm further along: as much steel, 1e-3 m2 more on one side and less on the other.
TEST(ProfileComparison, ShiftedLifterCountsOnBothSides) {
  LinerProfile shifted = square_lifter();
  for (std::size_t i = 2; i < 6; ++i) shifted.nodes[i].x() += 0.01;
  const auto found = compare(shifted, square_lifter());
  EXPECT_NEAR(found.signed_area, 0.0, 1e-12);
  EXPECT_NEAR(found.absolute_area, 2e-3, 4e-9);
}

// The farthest place of b is in the middle of a long segment, where no node is: a bump of a that
// stands 0.1 m over it.
TEST(ProfileComparison, FindsTheFarthestPlaceBetweenNodes) {
  LinerProfile valley = square_lifter();
  LinerProfile flat = square_lifter();
  flat.nodes.erase(flat.nodes.begin() + 2, flat.nodes.begin() + 6);
  valley.nodes[2] = {-0.15, 0.0};
  valley.nodes[3] = {-0.15, 0.1};
  valley.nodes[4] = {0.15, 0.1};
  valley.nodes[5] = {0.15, 0.0};
  // Place (0, 0) of the flat plate lies 0.1 m under the top; sqrt would be more to the feet.
  EXPECT_NEAR(compare(flat, valley).hausdorff, 0.1, hausdorff_tolerance);
}

TEST(ProfileComparison, HighestAboveCountsOneSideOnly) {
  EXPECT_NEAR(highest_above(square_lifter(), narrower_lifter()), 0.01, 1e-9);
  EXPECT_NEAR(highest_above(narrower_lifter(), square_lifter()), 0.0, 1e-12);
  EXPECT_NEAR(highest_above(bare_ring(0.99, 400), bare_ring(1.0, 400)), 0.01, 1e-6);
  EXPECT_EQ(highest_above(bare_ring(1.01), bare_ring(1.0)), 0.0);
}

TEST(ProfileComparison, RefusesAnotherMill) {
  LinerProfile other = bare_ring();
  other.sector.rows = 12;
  EXPECT_THROW(static_cast<void>(compare(bare_ring(), other)), InputError);
  EXPECT_THROW(static_cast<void>(highest_above(bare_ring(), other)), InputError);
}

TEST(SignedSurface, TellsSteelFromTheOpen) {
  const SignedSurface surface(square_lifter(), 0.1);
  const auto above = surface.place({0.0, 0.13});
  EXPECT_NEAR(above.height, 0.03, 1e-12);
  EXPECT_NEAR((above.position - Eigen::Vector2d(0.0, 0.1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((above.outward - Eigen::Vector2d(0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(surface.place({0.03, 0.05}).height, -0.02, 1e-12);
  EXPECT_NEAR((surface.place({0.03, 0.05}).outward - Eigen::Vector2d(1.0, 0.0)).norm(), 0, 1e-12);
  EXPECT_NEAR(surface.place({0.08, 0.14}).height, 0.05, 1e-12);    // off the corner
  EXPECT_NEAR(surface.place({0.06, 0.005}).height, 0.005, 1e-12);  // over the foot
  EXPECT_NEAR(surface.place({0.06, -0.005}).height, -0.005, 1e-12);
}

// On the next pitch the same heights, and places there.
TEST(SignedSurface, GoesOnAroundTheMill) {
  const SignedSurface surface(square_lifter(), 0.1);
  for (const int pitch : {-2, -1, 1, 2, 4}) {
    const Eigen::Vector2d point(0.01, 0.12);
    const auto place = surface.place(shifted_by_pitches(sample_sector, point, pitch));
    EXPECT_NEAR(place.height, 0.02, 1e-12);
    EXPECT_LT(
        (place.position - shifted_by_pitches(sample_sector, Eigen::Vector2d(0.01, 0.1), pitch))
            .norm(),
        1e-12);
  }
  const Eigen::Vector2d beyond = point_at(sample_sector, 0.99, 0.5001 * sample_sector.pitch());
  EXPECT_GT(surface.place(beyond).height, 0.009);
}

}  // namespace
}  // namespace millwear::wear
