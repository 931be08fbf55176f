#include "mill/liner/mill_frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace millwear {
namespace {

struct Place {
  LinerSector sector;
  double radius;
  double share;  ///< of half a pitch from the lifter's centre, clear of the sector edges
  int row;
  double mill_angle;
};

Place any_place() {
  const int rows = *rc::gen::inRange(3, 80);
  return {{4.1, 4.0, rows},
          0.5 + *rc::gen::inRange(0, 3500) * 1e-3,
          *rc::gen::inRange(-999, 1000) * 1e-3,
          *rc::gen::inRange(0, rows),
          *rc::gen::inRange(-20000, 20000) * 1e-3};
}

Eigen::Vector2d point_of(const Place& place) {
  return point_at(place.sector, place.radius, place.share * 0.5 * place.sector.pitch());
}

// Lifter 0 at six o'clock: (xi, eta) = (-x, z + R).
TEST(MillFrame, MasterFrameAtSixOClock) {
  const LinerSector sector{4.1, 4.0, 52};
  const MasterPoint point = to_master(sector, -0.1, -3.9, 0.0);
  EXPECT_EQ(point.row, 0);
  EXPECT_NEAR(point.position.x(), 0.1, 1e-14);
  EXPECT_NEAR(point.position.y(), 0.1, 1e-14);
}

// Turned by a quarter about +y, lifter 0 stands at nine o'clock on the rising side, x = -R.
TEST(MillFrame, QuarterTurnLiftsToNineOClock) {
  const LinerSector sector{4.1, 4.0, 4};
  const Eigen::Vector2d place = to_mill(sector, {0.0, 0.0}, 0, 0.5 * std::numbers::pi);
  EXPECT_NEAR(place.x(), -4.0, 1e-14);
  EXPECT_NEAR(place.y(), 0.0, 1e-14);
  EXPECT_EQ(to_master(sector, -4.0, 0.0, 0.0).row, 1);
  EXPECT_EQ(to_master(sector, -4.0, 0.0, 0.5 * std::numbers::pi).row, 0);
}

TEST(MillFrame, AnglesAroundTheClock) {
  EXPECT_DOUBLE_EQ(angle_from_six_oclock(0.0, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(angle_from_six_oclock(-1.0, 0.0), 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(angle_from_six_oclock(1.0, 0.0), -0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(angle_from_six_oclock(0.0, 1.0), std::numbers::pi);
}

RC_GTEST_PROP(MillFrame, RoundTrip, ()) {
  const Place place = any_place();
  const Eigen::Vector2d point = point_of(place);
  const Eigen::Vector2d mill = to_mill(place.sector, point, place.row, place.mill_angle);
  const MasterPoint back = to_master(place.sector, mill.x(), mill.y(), place.mill_angle);
  RC_ASSERT(back.row == place.row);
  RC_ASSERT((back.position - point).norm() < 1e-11);
}

RC_GTEST_PROP(MillFrame, TurningByOnePitchChangesNothing, ()) {
  const Place place = any_place();
  const Eigen::Vector2d mill = to_mill(place.sector, point_of(place), place.row, place.mill_angle);
  const MasterPoint here = to_master(place.sector, mill.x(), mill.y(), place.mill_angle);
  const MasterPoint turned =
      to_master(place.sector, mill.x(), mill.y(), place.mill_angle + place.sector.pitch());
  RC_ASSERT((turned.position - here.position).norm() < 1e-11);
  RC_ASSERT(turned.row == (here.row + place.sector.rows - 1) % place.sector.rows);
}

// Any place of the mill lands within half a pitch of the lifter's centre.
RC_GTEST_PROP(MillFrame, FoldsIntoTheSector, ()) {
  const LinerSector sector{4.1, 4.0, *rc::gen::inRange(3, 80)};
  const double x = *rc::gen::inRange(-4000, 4000) * 1e-3;
  const double z = *rc::gen::inRange(1, 4000) * 1e-3;
  const MasterPoint point = to_master(sector, x, z, *rc::gen::inRange(-50, 50) * 0.37);
  RC_ASSERT(std::abs(angle_of(sector, point.position)) <= 0.5 * sector.pitch() + 1e-12);
  RC_ASSERT(std::abs(radius_of(sector, point.position) - std::hypot(x, z)) < 1e-13);
}

}  // namespace
}  // namespace millwear
