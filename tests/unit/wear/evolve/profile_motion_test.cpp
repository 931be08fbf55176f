#include "wear/evolve/profile_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double bin = 0.004;

bool has_node(const LinerProfile& profile, const Eigen::Vector2d& node) {
  return std::find(profile.nodes.begin(), profile.nodes.end(), node) != profile.nodes.end();
}

/// Depth 1 between two arc lengths, 0 elsewhere, with ramps of one bin.
auto depth_between(double from, double to) {
  return [from, to](double s) { return std::clamp(std::min(s - from, to - s) / bin, 0.0, 1.0); };
}

MovedProfile moved(const LinerProfile& profile, const std::function<double(double)>& depth,
                   double area) {
  return move_profile(profile, loss_nodes(profile, bin, depth), area, bin);
}

TEST(ProfileMotion, RemovesExactlyTheTarget) {
  const auto profile = square_lifter();
  for (const double area : {1e-7, 1e-6, 1e-4, 1e-3}) {
    const auto worn = moved(
        profile, [](double s) { return 1.0 + std::sin(20.0 * s); }, area);
    EXPECT_NEAR(worn.removed_area, area, 1e-9 * area);
    EXPECT_NEAR(steel_area(profile) - steel_area(worn.profile), area, 1e-9 * area);
  }
}

// Only the leading face is loaded, between 0.02 and 0.08 of its height.
TEST(ProfileMotion, LeavesUnloadedCornersSharp) {
  const auto profile = square_lifter();
  const double top = arc_lengths(profile)[4];
  const auto worn = moved(profile, depth_between(top + 0.02, top + 0.08), 5e-5);
  for (const auto& node : profile.nodes) EXPECT_TRUE(has_node(worn.profile, node));
  EXPECT_NEAR(worn.removed_area, 5e-5, 5e-14);
}

TEST(ProfileMotion, EndsAtOneRadius) {
  const auto worn = moved(
      bare_ring(), [](double s) { return 1.0 + s; }, 1e-4);
  const auto& nodes = worn.profile.nodes;
  EXPECT_NEAR(radius_of(sample_sector, nodes.front()), radius_of(sample_sector, nodes.back()),
              1e-14);
  EXPECT_NEAR(angle_of(sample_sector, nodes.back()) - angle_of(sample_sector, nodes.front()),
              sample_sector.pitch(), 1e-14);
}

// A tooth 0.1 m wide is cut off 0.05 m under its top from both sides; its head goes with it.
TEST(ProfileMotion, DropsWhatLosesItsHold) {
  const auto profile = square_lifter();
  const auto lengths = arc_lengths(profile);
  const auto trailing = depth_between(lengths[2] + 0.03, lengths[2] + 0.06);
  const auto leading = depth_between(lengths[5] - 0.06, lengths[5] - 0.03);
  const double cut = 0.1 * 0.0265;
  const auto worn = moved(
      profile, [&](double s) { return trailing(s) + leading(s); }, cut);
  EXPECT_NEAR(worn.removed_area, cut + worn.dropped_area, 1e-9 * cut);
  EXPECT_NEAR(worn.dropped_area, 0.1 * 0.04, 3e-4);
  EXPECT_LT(lifter_height(worn.profile) - lifter_height(profile), -0.03);
  EXPECT_EQ(first_crossing(worn.profile), std::pair(-1, -1));
}

// The face is undercut below a wide cap: the profile doubles back over itself.
TEST(ProfileMotion, KeepsAnUndercut) {
  const auto profile = square_lifter();
  const double foot = arc_lengths(profile)[5];
  const auto worn = moved(profile, depth_between(foot - 0.05, foot - 0.01), 5e-4);
  EXPECT_TRUE(has_node(worn.profile, {0.05, 0.1}));
  const auto deepest = std::min_element(
      worn.profile.nodes.begin(), worn.profile.nodes.end(), [](const auto& a, const auto& b) {
        const auto key = [](const auto& p) {
          return p.y() > 0.005 && p.x() > 0.0 && p.y() < 0.06 ? p.x() : 1.0;
        };
        return key(a) < key(b);
      });
  EXPECT_LT(deepest->x(), 0.04);
  EXPECT_EQ(first_crossing(worn.profile), std::pair(-1, -1));
}

// The plate is 0.05 m thick and wears evenly; lifter-less, 0.628 m of it.
TEST(ProfileMotion, GoesThroughThePlate) {
  const auto ring = bare_ring();
  const auto dent = depth_between(0.3, 0.32);
  EXPECT_GT(plate_thickness(moved(ring, dent, 4e-4).profile), 0.0);
  EXPECT_LE(plate_thickness(moved(ring, dent, 1.5e-3).profile), 0.0);
}

TEST(ProfileMotion, RefusesWhatCannotBe) {
  const auto ring = bare_ring();
  const auto even = [](double) { return 1.0; };
  const auto none = [](double) { return 0.0; };
  EXPECT_THROW(static_cast<void>(moved(ring, even, steel_area(ring))), ResultRejected);
  EXPECT_THROW(static_cast<void>(moved(ring, none, 1e-4)), ResultRejected);
  EXPECT_THROW(static_cast<void>(moved(ring, even, -1e-4)), InputError);
}

TEST(ProfileMotion, OfNothingIsTheSameProfile) {
  const auto profile = square_lifter();
  const auto same = moved(
      profile, [](double) { return 0.0; }, 0.0);
  EXPECT_EQ(same.profile.nodes, profile.nodes);
}

}  // namespace
}  // namespace millwear::wear
