#include "wear/surface/closing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr double radius = 0.02;
/// A place counts as touched where the ball misses it by this.
constexpr double within = touched_within * radius;

/// The shadow over an arc length; an empty one where it is touched.
Shadow shadow_over(const Closing& closing, double arc_length) {
  for (const Shadow& shadow : closing.shadows)
    if (shadow.from <= arc_length && arc_length <= shadow.to) return shadow;
  return {0.0, 0.0};
}

TEST(Closing, OfAConcaveRingIsTheRing) {
  const auto ring = bare_ring();
  const auto closing = closing_of(ring, radius);
  EXPECT_TRUE(closing.shadows.empty());
  EXPECT_EQ(closing.surface.nodes, ring.nodes);
}

// A ball in a foot of 90 degrees touches both sides at its radius from the foot; its arc cuts
// r^2 (1 - pi / 4) off the corner.
TEST(Closing, RoundsAFoot) {
  const auto lifter = square_lifter();
  const auto lengths = arc_lengths(lifter);
  const auto closing = closing_of(lifter, radius);
  for (const double foot : {lengths[2], lengths[5]}) {
    const Shadow shadow = shadow_over(closing, foot);
    EXPECT_NEAR(shadow.from, foot - radius, within);
    EXPECT_NEAR(shadow.to, foot + radius, within);
  }
  const double filled = steel_area(closing.surface) - steel_area(lifter);
  const double expected = 2.0 * radius * radius * (1.0 - std::numbers::pi / 4.0);
  EXPECT_NEAR(filled, expected, 0.05 * expected);
  for (const auto& edge : {lifter.nodes[3], lifter.nodes[4]})
    EXPECT_NE(std::find(closing.surface.nodes.begin(), closing.surface.nodes.end(), edge),
              closing.surface.nodes.end())
        << "an edge stays sharp";
}

// A slot 10 mm wide and 30 mm deep: the ball lies on its two edges.
LinerProfile slotted() {
  const double half = 0.5 * sample_sector.pitch();
  return {sample_sector,
          {point_at(sample_sector, 1.0, -half),
           {-0.1, 0.0},
           {-0.005, 0.0},
           {-0.005, -0.03},
           {0.005, -0.03},
           {0.005, 0.0},
           {0.1, 0.0},
           point_at(sample_sector, 1.0, half)}};
}

TEST(Closing, LiesOnTheEdgesOfASlot) {
  const auto slot = slotted();
  const auto lengths = arc_lengths(slot);
  const auto closing = closing_of(slot, radius);
  const Shadow shadow = shadow_over(closing, lengths[3]);
  EXPECT_NEAR(shadow.from, lengths[2], 1e-9);
  EXPECT_NEAR(shadow.to, lengths[5], 1e-9);
  const double sagitta = radius - std::sqrt(radius * radius - 0.005 * 0.005);
  double lowest = 0.0;
  for (const auto& node : closing.surface.nodes)
    if (std::abs(node.x()) < 0.005) lowest = std::min(lowest, node.y());
  EXPECT_NEAR(lowest, -sagitta, 0.15 * sagitta);
}

// The same slot with the sector's edge in its middle.
TEST(Closing, FollowsAShadowOntoTheNextPitch) {
  const LinerProfile slot = slotted();
  const double half = 0.5 * sample_sector.pitch();
  const auto half_pitch_on = [&](const Eigen::Vector2d& point) {
    return point_at(sample_sector, radius_of(sample_sector, point),
                    angle_of(sample_sector, point) + half);
  };
  LinerProfile turned{sample_sector, {point_at(sample_sector, 1.03, -half)}};
  for (const std::size_t i : {4, 5, 6})
    turned.nodes.push_back(shifted_by_pitches(sample_sector, half_pitch_on(slot.nodes[i]), -1));
  for (const std::size_t i : {1, 2, 3}) turned.nodes.push_back(half_pitch_on(slot.nodes[i]));
  turned.nodes.push_back(point_at(sample_sector, 1.03, half));
  const double length = arc_lengths(turned).back();
  const auto closing = closing_of(turned, radius);
  const Shadow shadow = shadow_over(closing, length);
  EXPECT_GT(shadow.from, 0.5 * length);
  EXPECT_GT(shadow.to, length);
  const auto& nodes = closing.surface.nodes;
  EXPECT_NEAR((shifted_by_pitches(sample_sector, nodes.front(), 1) - nodes.back()).norm(), 0.0,
              1e-9);
  EXPECT_LT(
      (nodes.front() - shifted_by_pitches(sample_sector, half_pitch_on(slot.nodes[5]), -1)).norm(),
      1e-9);
}

TEST(Closing, TakesABall) {
  EXPECT_THROW(static_cast<void>(closing_of(bare_ring(), 0.0)), std::logic_error);
}

}  // namespace
}  // namespace millwear::wear
