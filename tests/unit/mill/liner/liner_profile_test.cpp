#include "mill/liner/liner_profile.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

constexpr LinerSector sector{0.52, 0.5, 12};

/// A plate of `facets` facets on the circle of `radius` [m].
LinerProfile bare_plate(double radius, int facets) {
  LinerProfile profile{sector, {}};
  for (int i = 0; i <= facets; ++i) {
    profile.nodes.push_back(
        point_at(sector, radius, sector.pitch() * (static_cast<double>(i) / facets - 0.5)));
  }
  return profile;
}

TEST(LinerSector, PlacesPointsByHand) {
  EXPECT_NEAR(radius_of(sector, {0.0, 0.0}), 0.5, 1e-15);
  EXPECT_NEAR(radius_of(sector, {0.0, 0.1}), 0.4, 1e-15);
  EXPECT_NEAR(angle_of(sector, {0.3, 0.5}), std::numbers::pi / 2.0, 1e-15);
  EXPECT_TRUE(point_at(sector, 0.5, std::numbers::pi / 2.0).isApprox(Eigen::Vector2d(0.5, 0.5)));
}

RC_GTEST_PROP(LinerSector, PolarRoundTrip, ()) {
  const double radius = 0.01 + *rc::gen::inRange(1, 100000) * 1e-5;
  const double angle = *rc::gen::inRange(-314000, 314000) * 1e-5;
  const Eigen::Vector2d point = point_at(sector, radius, angle);
  RC_ASSERT(std::abs(radius_of(sector, point) - radius) < 1e-14);
  RC_ASSERT(std::abs(angle_of(sector, point) - angle) < 1e-12);
}

TEST(LinerSector, RowsShiftsLeadBackToTheStart) {
  const Eigen::Vector2d point(0.05, 0.03);
  EXPECT_LT((shifted_by_pitches(sector, point, sector.rows) - point).norm(), 1e-15);
  EXPECT_GT(shifted_by_pitches(sector, point, 1).x(), point.x());
}

TEST(LinerProfile, ArcLengthsAddUpSegments) {
  const LinerProfile profile{sector, {{0.0, 0.0}, {3.0, 4.0}, {3.0, 5.0}}};
  EXPECT_EQ(arc_lengths(profile), (std::vector<double>{0.0, 5.0, 6.0}));
}

// A ring of 12 sectors between radii 0.50 and 0.52 m: pi (0.52^2 - 0.5^2) / 12.
TEST(LinerProfile, SteelOfABarePlateIsARing) {
  const double ring = std::numbers::pi * (0.52 * 0.52 - 0.25) / 12.0;
  EXPECT_NEAR(steel_area(bare_plate(0.5, 2000)), ring, 1e-9);
  EXPECT_NEAR(lifter_area(bare_plate(0.5, 2000)), 0.0, 1e-7);
}

// Plate worn from radius 0.50 to 0.51 m: 10 mm are left, and its crest is 10 mm under the new
// plate.
TEST(LinerProfile, WornPlateIsThinAndHasNoLifter) {
  const LinerProfile worn = bare_plate(0.51, 500);
  EXPECT_NEAR(plate_thickness(worn), 0.01, 1e-12);
  EXPECT_NEAR(lifter_area(worn), 0.0, 1e-15);
  EXPECT_NEAR(lifter_height(worn), 0.50 - 0.51 * std::cos(sector.pitch() / 1000.0), 1e-12);
}

// Steel above the new plate and steel below it make up the whole where the plate is as new.
TEST(LinerProfile, LifterIsTheSteelAboveThePlate) {
  const LinerProfile profile = profile_of(sector, {0.04, 0.05, 0.3, 0.2});
  const double ring = std::numbers::pi * (0.52 * 0.52 - 0.25) / 12.0;
  EXPECT_NEAR(steel_area(profile) - ring, lifter_area(profile), 1e-12);
}

TEST(LinerProfile, MirrorSwapsTheFaces) {
  const LinerProfile profile = profile_of(sector, {0.04, 0.05, 0.3, 0.1});
  EXPECT_NEAR(leading_face_angle(profile), 0.3, 1e-12);
  EXPECT_NEAR(leading_face_angle(mirrored(profile)), 0.1, 1e-12);
  EXPECT_NEAR(steel_area(mirrored(profile)), steel_area(profile), 1e-14);
  EXPECT_EQ(mirrored(mirrored(profile)).nodes, profile.nodes);
}

// A worn tip of 2 mm across the leading corner leaves the face between 20 and 80 % as it was.
TEST(LinerProfile, FaceAngleLeavesOutTheCorner) {
  LinerProfile profile = profile_of(sector, {0.04, 0.05, 0.3, 0.2});
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const Eigen::Vector2d corner = profile.nodes[i];
    if (corner == Eigen::Vector2d(0.025, 0.04)) {
      const Eigen::Vector2d down = (profile.nodes[i + 1] - corner).normalized();
      profile.nodes[i] = corner - Eigen::Vector2d(0.002, 0.0);
      profile.nodes.insert(profile.nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                           corner + 0.002 * down);
      break;
    }
  }
  EXPECT_NEAR(leading_face_angle(profile), 0.3, 1e-12);
}

// A radius r between lines that turn by q, in n facets, takes r^2 (tan(q/2) - n/2 sin(q/n)) off a
// corner of the top and puts it into one of the feet. On a plate of 50 m the feet turn by as much.
TEST(ParametricLifter, HasItsRadii) {
  constexpr LinerSector flat{50.1, 50.0, 400};
  constexpr double angle = 0.2;
  const auto area = [&flat](double top, double foot) {
    return lifter_area(profile_of(flat, {0.2, 0.15, angle, angle, top, foot}));
  };
  const double turn = 0.5 * std::numbers::pi - angle;
  const double facets = std::ceil(turn / (2.0 * std::acos(0.99)));
  const double corner = std::tan(0.5 * turn) - 0.5 * facets * std::sin(turn / facets);
  const double plain = area(0.0, 0.0);
  EXPECT_NEAR((plain - area(0.03, 0.0)) / (2.0 * 0.03 * 0.03 * corner), 1.0, 1e-9);
  EXPECT_NEAR((area(0.0, 0.04) - plain) / (2.0 * 0.04 * 0.04 * corner), 1.0, 0.01);
  const LinerProfile lifter = profile_of(flat, {0.2, 0.15, angle, angle, 0.03, 0.04});
  EXPECT_NEAR(lifter_height(lifter), 0.2, 1e-9);
  EXPECT_NEAR(leading_face_angle(lifter), angle, 0.02);
}

TEST(ParametricLifter, RefusesRadiiWithoutRoom) {
  EXPECT_THROW(static_cast<void>(profile_of(sector, {0.04, 0.03, 0.2, 0.2, 0.03, 0.0})),
               InputError);
  EXPECT_THROW(static_cast<void>(profile_of(sector, {0.04, 0.1, 0.2, 0.2, 0.02, 0.04})),
               InputError);
}

}  // namespace
}  // namespace millwear
