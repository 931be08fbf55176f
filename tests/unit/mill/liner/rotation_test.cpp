#include "mill/liner/rotation.h"

#include <gtest/gtest.h>

#include <vector>

#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

constexpr double hour = 3600.0;
const std::vector<double> twice = {2000.0 * hour, 4000.0 * hour};

TEST(Rotation, ChangesAtEveryReversal) {
  EXPECT_EQ(rotation_after(twice, 0.0), Rotation::as_new);
  EXPECT_EQ(rotation_after(twice, 1999.0 * hour), Rotation::as_new);
  EXPECT_EQ(rotation_after(twice, 2000.0 * hour), Rotation::reversed);
  EXPECT_EQ(rotation_after(twice, 3999.0 * hour), Rotation::reversed);
  EXPECT_EQ(rotation_after(twice, 4000.0 * hour), Rotation::as_new);
  EXPECT_EQ(reversals_by(twice, 1e9), 2);
}

// Steps whose sum falls short of the reversal by rounding have reached it.
TEST(Rotation, IsReversedByStepsThatSumToTheReversal) {
  double time = 0.0;
  for (int step = 0; step < 7; ++step) time += 2000.0 * hour / 7.0;
  EXPECT_EQ(rotation_after(twice, time), Rotation::reversed);
  EXPECT_EQ(rotation_after(twice, 2000.0 * hour - 0.5), Rotation::reversed);
  EXPECT_EQ(rotation_after(twice, 2000.0 * hour - 2.0), Rotation::as_new);
}

TEST(Rotation, KnowsTheNextReversal) {
  EXPECT_DOUBLE_EQ(*time_to_reversal(twice, 500.0 * hour), 1500.0 * hour);
  EXPECT_DOUBLE_EQ(*time_to_reversal(twice, 2000.0 * hour), 2000.0 * hour);
  EXPECT_GT(*time_to_reversal(twice, 2000.0 * hour - 0.5), hour);
  EXPECT_FALSE(time_to_reversal(twice, 4000.0 * hour).has_value());
}

TEST(Rotation, OfAMillWithoutReversalsStays) {
  EXPECT_EQ(rotation_after({}, 1e9), Rotation::as_new);
  EXPECT_FALSE(time_to_reversal({}, 0.0).has_value());
}

// The face that led trails in a mill that turns the other way.
TEST(Rotation, TurnsTheLiner) {
  const LinerSector sector{1.05, 1.0, 10};
  const LinerProfile lifter{sector,
                            {point_at(sector, 1.0, -0.5 * sector.pitch()),
                             {-0.05, 0.0},
                             {-0.05, 0.1},
                             {0.02, 0.1},
                             {0.05, 0.0},
                             point_at(sector, 1.0, 0.5 * sector.pitch())}};
  EXPECT_EQ(as_turned(lifter, Rotation::as_new).nodes, lifter.nodes);
  const auto turned = as_turned(lifter, Rotation::reversed);
  EXPECT_EQ(turned.nodes[1], Eigen::Vector2d(-0.05, 0.0));
  EXPECT_EQ(turned.nodes[2], Eigen::Vector2d(-0.02, 0.1));
  EXPECT_GT(leading_face_angle(lifter), 0.2);
  EXPECT_NEAR(leading_face_angle(turned), 0.0, 1e-12);
  EXPECT_EQ(as_turned(turned, Rotation::reversed).nodes, lifter.nodes);
}

// What stands at +xi stands at -xi, and what came first along the surface comes last.
TEST(Rotation, TurnsWhatLiesOnTheLiner) {
  const Eigen::Vector2d point(0.02, 0.1);
  EXPECT_EQ(as_turned(point, Rotation::as_new), point);
  EXPECT_EQ(as_turned(point, Rotation::reversed), Eigen::Vector2d(-0.02, 0.1));
  const std::vector<double> at_nodes = {1.0, 2.0, 5.0};
  EXPECT_EQ(as_turned(at_nodes, Rotation::as_new), at_nodes);
  EXPECT_EQ(as_turned(at_nodes, Rotation::reversed), (std::vector<double>{5.0, 2.0, 1.0}));
  const Eigen::Matrix<double, 3, 2> by_bin{{1.0, 10.0}, {2.0, 20.0}, {5.0, 50.0}};
  const Eigen::Matrix<double, 3, 2> turned{{5.0, 50.0}, {2.0, 20.0}, {1.0, 10.0}};
  EXPECT_EQ(by_bin_as_turned(by_bin, Rotation::as_new), by_bin);
  EXPECT_EQ(by_bin_as_turned(by_bin, Rotation::reversed), turned);
}

}  // namespace
}  // namespace millwear
