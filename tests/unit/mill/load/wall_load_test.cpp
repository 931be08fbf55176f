#include "mill/load/wall_load.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear {
namespace {

/// Two bins of 0.1 and 0.3 m, two classes, three blocks; sliding work 1, 2, 3, ... by columns.
WallLoad small_load() {
  WallLoad load{.slice_length = 0.5,
                .rows = 4,
                .duration = 2.0,
                .bin_edges = Eigen::Vector3d(0.0, 0.1, 0.4),
                .class_count = 2,
                .block_count = 3,
                .values = {},
                .rejected = {}};
  load.values.fill(Eigen::MatrixXd::Zero(2, 6));
  load.values[static_cast<std::size_t>(Measure::sliding_work)] << 1, 2, 3, 4, 5, 6,  //
      10, 20, 30, 40, 50, 60;
  return load;
}

TEST(WallLoad, BinsHaveWidthAndArea) {
  const WallLoad load = small_load();
  EXPECT_EQ(load.bins(), 2);
  EXPECT_TRUE(load.bin_widths().isApprox(Eigen::Vector2d(0.1, 0.3)));
  EXPECT_TRUE(load.bin_area().isApprox(Eigen::Vector2d(0.05, 0.15)));
}

TEST(WallLoad, TotalSumsClassesAndBlocks) {
  EXPECT_EQ(small_load().total(Measure::sliding_work), Eigen::Vector2d(21.0, 210.0));
  EXPECT_EQ(small_load().total(Measure::samples), Eigen::Vector2d(0.0, 0.0));
}

// Blocks of class 0 are columns 0 to 2, those of class 1 columns 3 to 5.
TEST(WallLoad, ByBlockSumsClasses) {
  Eigen::MatrixXd expected(2, 3);
  expected << 5, 7, 9, 50, 70, 90;
  EXPECT_EQ(small_load().by_block(Measure::sliding_work), expected);
}

TEST(WallLoad, PathOverSlipIsOfTheWholeLiner) {
  WallLoad load = small_load();
  load.values[index_of(Measure::path_work)].col(4) << 300.0, 47.0 + 0.5 * 231.0;
  EXPECT_DOUBLE_EQ(path_over_slip(load), (347.0 + 115.5) / 231.0);
  load.values[index_of(Measure::sliding_work)].setZero();
  EXPECT_TRUE(std::isnan(path_over_slip(load)));
}

}  // namespace
}  // namespace millwear
