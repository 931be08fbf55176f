#include "wear/numerics/block_persistence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace millwear::wear {
namespace {

/// Places x blocks of a first-order autoregression with this correlation from block to block, each
/// place by itself.
Eigen::MatrixXd series(double correlation, Eigen::Index blocks, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd values(120, blocks);
  for (Eigen::Index place = 0; place < values.rows(); ++place) {
    double value = normal(random);
    for (Eigen::Index b = 0; b < blocks; ++b) {
      values(place, b) = 10.0 + value;
      value = correlation * value + std::sqrt(1.0 - correlation * correlation) * normal(random);
    }
  }
  return values;
}

double mean_persistence(double correlation, Eigen::Index blocks) {
  double sum = 0.0;
  for (unsigned seed = 0; seed < 200; ++seed) sum += persistence(series(correlation, blocks, seed));
  return sum / 200.0;
}

// (1 + rho) / (1 - rho) = 1, 1.86, 3. Of independent blocks it is above 1, because it is cut there.
TEST(Persistence, IsThatOfAnAutoregression) {
  EXPECT_NEAR(mean_persistence(0.0, 13), 1.1, 0.1);
  EXPECT_NEAR(mean_persistence(0.3, 13), 1.86, 0.2);
  EXPECT_NEAR(mean_persistence(0.5, 13), 3.0, 0.4);
  EXPECT_NEAR(mean_persistence(0.5, 50), 3.0, 0.15);
}

TEST(Persistence, IsNoneOfFewBlocksOrOfASteadyLoad) {
  EXPECT_EQ(persistence(series(0.5, 7, 1)), 1.0);
  EXPECT_EQ(persistence(Eigen::MatrixXd::Constant(40, 13, 2.0)), 1.0);
}

TEST(AsIndependent, KeepsTheMeanAndWidensTheScatterOfEveryPlaceAlike) {
  const Eigen::MatrixXd blocks = series(0.5, 13, 3);
  const Eigen::MatrixXd wide = as_independent(blocks);
  const Eigen::VectorXd mean = blocks.rowwise().mean();
  EXPECT_LT((wide.rowwise().mean() - mean).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd before = (blocks.colwise() - mean).rowwise().squaredNorm();
  const Eigen::VectorXd after = (wide.colwise() - mean).rowwise().squaredNorm();
  EXPECT_LT((after.array() / before.array() - persistence(blocks)).abs().maxCoeff(), 1e-9);
  EXPECT_GT(persistence(blocks), 1.5);
}

}  // namespace
}  // namespace millwear::wear
