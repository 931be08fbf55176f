#include "mill/liner/parametric_lifter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

constexpr LinerSector sector{0.52, 0.5, 12};

ParametricLifter any_lifter() {
  return {0.005 + *rc::gen::inRange(0, 70) * 1e-3, 0.01 + *rc::gen::inRange(0, 60) * 1e-3,
          *rc::gen::inRange(0, 700) * 1e-3, *rc::gen::inRange(0, 700) * 1e-3};
}

/// The part of a disc between a chord and its arc, over `angle` [rad].
double circular_segment(double radius, double angle) {
  return 0.5 * radius * radius * (angle - std::sin(angle));
}

double area_of_polygon(const std::vector<Eigen::Vector2d>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& p = corners[i];
    const Eigen::Vector2d& q = corners[(i + 1) % corners.size()];
    area += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  return std::abs(area);
}

/// Where a face from (half width, height) down at `angle` meets the circle, found by bisection.
Eigen::Vector2d foot_by_bisection(const ParametricLifter& lifter, double angle) {
  double low = 0.0;
  double high = 2.0 * lifter.height;
  const auto at = [&](double drop) -> Eigen::Vector2d {
    return {0.5 * lifter.top_width + drop * std::tan(angle), lifter.height - drop};
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (radius_of(sector, at(middle)) < sector.plate_radius ? low : high) = middle;
  }
  return at(low);
}

// Trapezium over the chord of the foot, the circular segment under it, and one more segment for
// every facet of the plate.
RC_GTEST_PROP(ParametricLifter, AreaHasAClosedForm, ()) {
  const ParametricLifter lifter = any_lifter();
  const Eigen::Vector2d leading = foot_by_bisection(lifter, lifter.leading_face_angle);
  const Eigen::Vector2d trailing = foot_by_bisection(lifter, lifter.trailing_face_angle)
                                       .cwiseProduct(Eigen::Vector2d(-1.0, 1.0));
  const double half = 0.5 * lifter.top_width;
  double area =
      area_of_polygon({trailing, {-half, lifter.height}, {half, lifter.height}, leading}) +
      circular_segment(0.5, angle_of(sector, leading) - angle_of(sector, trailing));
  const LinerProfile profile = profile_of(sector, lifter);
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const bool on_plate = std::abs(radius_of(sector, profile.nodes[i]) - 0.5) < 1e-12 &&
                          std::abs(radius_of(sector, profile.nodes[i + 1]) - 0.5) < 1e-12;
    if (on_plate) {
      area += circular_segment(
          0.5, angle_of(sector, profile.nodes[i + 1]) - angle_of(sector, profile.nodes[i]));
    }
  }
  RC_ASSERT(std::abs(lifter_area(profile) - area) < 1e-12);
}

RC_GTEST_PROP(ParametricLifter, HeightAndFaceAnglesAreExact, ()) {
  const ParametricLifter lifter = any_lifter();
  const LinerProfile profile = profile_of(sector, lifter);
  RC_ASSERT(std::abs(lifter_height(profile) - lifter.height) < 1e-14);
  RC_ASSERT(std::abs(leading_face_angle(profile) - lifter.leading_face_angle) < 1e-9);
  RC_ASSERT(std::abs(leading_face_angle(mirrored(profile)) - lifter.trailing_face_angle) < 1e-9);
  RC_ASSERT(std::abs(plate_thickness(profile) - 0.02) < 1e-14);
}

RC_GTEST_PROP(ParametricLifter, IsOrderedSimpleAndPeriodic, ()) {
  const PlateShape plate = *rc::gen::element(PlateShape::arc, PlateShape::straight);
  const LinerProfile profile = profile_of(sector, any_lifter(), plate);
  RC_ASSERT(first_crossing(profile) == (std::pair<int, int>(-1, -1)));
  RC_ASSERT((shifted_by_pitches(sector, profile.nodes.front(), 1) - profile.nodes.back()).norm() <
            1e-14);
  RC_ASSERT(std::abs(angle_of(sector, profile.nodes.front()) + 0.5 * sector.pitch()) < 1e-14);
}

// A lifter without a width would be all plate: facets stay within 0.1 mm of the circle.
TEST(ParametricLifter, PlateFacetsFollowTheArc) {
  for (const double radius : {0.1, 0.5, 4.0}) {
    const LinerSector mill{radius + 0.1, radius, 6};
    const auto nodes = nodes_between(mill, radius, -0.5, 0.5);
    ASSERT_GE(nodes.size(), 2U);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const double sagitta = radius - radius_of(mill, 0.5 * (nodes[i] + nodes[i + 1]));
      EXPECT_LE(sagitta, 1e-4);
      EXPECT_GE(sagitta, 1e-5) << "finer than it need be";
    }
  }
}

// Straight plate between lifters of two rows: foot, sector edge and the next foot lie on one line.
TEST(ParametricLifter, StraightPlateIsStraight) {
  const LinerProfile profile = profile_of(sector, {0.04, 0.05, 0.5, 0.1}, PlateShape::straight);
  ASSERT_EQ(profile.nodes.size(), 6U);
  const Eigen::Vector2d foot = profile.nodes[4];
  const Eigen::Vector2d edge = profile.nodes[5];
  const Eigen::Vector2d next_foot = shifted_by_pitches(sector, profile.nodes[1], 1);
  const Eigen::Vector2d a = (edge - foot).normalized();
  const Eigen::Vector2d b = (next_foot - edge).normalized();
  EXPECT_NEAR(a.x() * b.y() - a.y() * b.x(), 0.0, 1e-13);
  EXPECT_GT(a.dot(b), 0.0);
}

TEST(ParametricLifter, OverlapIsRefused) {
  EXPECT_THROW(static_cast<void>(profile_of(sector, {0.04, 0.30, 0.3, 0.3})), InputError);
  EXPECT_THROW(static_cast<void>(profile_of(sector, {0.6, 0.05, 0.0, 0.0})), InputError);
  EXPECT_THROW(static_cast<void>(profile_of(sector, {0.001, 0.2, 0.0, 0.0})), InputError);
}

}  // namespace
}  // namespace millwear
