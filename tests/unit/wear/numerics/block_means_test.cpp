#include "wear/numerics/block_means.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear::wear {
namespace {

TEST(BlockMeans, LeavesOutWhatDoesNotFillABlock) {
  EXPECT_EQ(block_means({1.0, 3.0, 5.0, 7.0, 9.0, 10.0, 99.0}, 3), Eigen::Vector3d(2.0, 6.0, 9.5));
}

TEST(BlockMeans, AreNoneOfASeriesShorterThanTheBlocks) {
  EXPECT_EQ(block_means({1.0, 2.0}, 3).size(), 0);
  EXPECT_EQ(block_means({}, 1).size(), 0);
}

// Of 1, 2, 3, 4 the variance is 5/3 and that of the mean a quarter of it.
TEST(ErrorOfMean, IsByRowAndUnknownOfOneBlock) {
  Eigen::MatrixXd rates(2, 4);
  rates << 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0;
  EXPECT_DOUBLE_EQ(error_of_mean(rates)[0], std::sqrt(5.0 / 12.0));
  EXPECT_EQ(error_of_mean(rates)[1], 0.0);
  EXPECT_TRUE(std::isnan(error_of_mean(rates.leftCols(1))[1]));
}

}  // namespace
}  // namespace millwear::wear
