#include "wear/wear_law.h"

#include <gtest/gtest.h>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

/// One bin 0.1 m wide on a slice of 0.1 m, i.e. 1e-2 m2, two time blocks.
WallLoad one_bin_load(double first_block, double second_block, int rows, double duration) {
  WallLoad load{};
  load.slice_length = 0.1;
  load.rows = rows;
  load.duration = duration;
  load.bin_edges = Eigen::Vector2d(0.0, 0.1);
  load.class_count = 1;
  load.block_count = 2;
  load.values.fill(Eigen::MatrixXd::Zero(1, 2));
  load.values[static_cast<std::size_t>(Measure::sliding_work)] << first_block, second_block;
  return load;
}

// A block pressed with 100 N and dragged 2 m at k = 1e-12 1/Pa loses 2e-10 m3: V = k F s.
TEST(Archard, LosesForceTimesDistance) {
  const auto load = one_bin_load(100.0 * 2.0, 0.0, 1, 4.0);
  EXPECT_DOUBLE_EQ(depth_rate(Archard{1e-12}, load)[0] * 4.0 * 1e-2, 2e-10);
}

// The same work shared by five lifters, or taken in half the time.
TEST(Archard, IsARatePerLifterAndSecond) {
  const Archard law{1e-12};
  const double alone = depth_rate(law, one_bin_load(200.0, 0.0, 1, 4.0))[0];
  EXPECT_DOUBLE_EQ(depth_rate(law, one_bin_load(200.0, 0.0, 5, 4.0))[0], alone / 5.0);
  EXPECT_DOUBLE_EQ(depth_rate(law, one_bin_load(200.0, 0.0, 1, 2.0))[0], alone * 2.0);
}

TEST(Archard, MeanOverBlocksIsTheWhole) {
  const auto load = one_bin_load(150.0, 50.0, 3, 4.0);
  const auto blocks = depth_rate_by_block(Archard{1e-12}, load);
  EXPECT_DOUBLE_EQ(blocks(0, 0), 3.0 * blocks(0, 1));
  EXPECT_DOUBLE_EQ(blocks.row(0).mean(), depth_rate(Archard{1e-12}, load)[0]);
}

TEST(Archard, RefusesABinWithoutArea) {
  auto load = one_bin_load(1.0, 1.0, 1, 1.0);
  load.bin_edges[1] = 0.0;
  EXPECT_THROW(static_cast<void>(depth_rate(Archard{1e-12}, load)), InputError);
}

}  // namespace
}  // namespace millwear::wear
