#include "wear/rate/smoothing_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 120;
const Eigen::VectorXd edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, 0.6);

Eigen::MatrixXd noisy_blocks(Eigen::Index blocks, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.3);
  return Eigen::MatrixXd::NullaryExpr(bins, blocks, [&](auto bin, auto) {
    return 3.0 + std::cos(2.0 * std::numbers::pi * static_cast<double>(bin) / bins) + noise(random);
  });
}

SmoothedLoss smoothed_mean(const Eigen::MatrixXd& by_block) {
  return smoothed(edges, by_block.rowwise().mean(), by_block);
}

/// Two bins: their errors are 3-4-5 triangles by hand.
SmoothedLoss known_modes() {
  const Eigen::Vector2d rates(50.0, 10.0);
  const Eigen::Vector2d as_the_bins(1.0, 1.0);
  SmoothedLoss loss{{Eigen::Vector3d(0.0, 1.0, 2.0), rates}, as_the_bins, rates, 0.0, 1.0, {}, {}};
  loss.block_modes = Eigen::MatrixXd{{3.0, 0.0}, {0.0, 5.0}};
  loss.bias_modes = Eigen::MatrixXd{{4.0}, {12.0}};
  return loss;
}

TEST(SmoothingError, IsTheRootOfTheSumOfSquaredModes) {
  const Eigen::VectorXd error = standard_error(known_modes());
  EXPECT_DOUBLE_EQ(error[0], 5.0);
  EXPECT_DOUBLE_EQ(error[1], 13.0);
}

// Over a way twice the bin the surface loses twice as much, with twice the error.
TEST(SmoothingError, GoesWithTheWayOfTheCentre) {
  SmoothedLoss loss = known_modes();
  loss.path[1] = 2.0;
  EXPECT_DOUBLE_EQ(standard_error(loss)[1], 26.0);
  EXPECT_DOUBLE_EQ(peak_error(loss), 3.0 / 50.0);
}

// The second bin is no peak: it is below half of the first. The bias, 4, does not count.
TEST(SmoothingError, OfThePeaksIsRelativeToThem) {
  EXPECT_DOUBLE_EQ(peak_error(known_modes()), 3.0 / 50.0);
}

TEST(SmoothingError, TakesTheWorstPeak) {
  SmoothedLoss loss = known_modes();
  loss.per_path = Eigen::Vector4d(50.0, 1.0, 26.0, 1.0);
  loss.block_modes = Eigen::MatrixXd{{3.0, 0.0}, {0.0, 9.0}, {0.0, 13.0}, {0.0, 9.0}};
  loss.bias_modes = Eigen::MatrixXd::Zero(4, 0);
  EXPECT_DOUBLE_EQ(peak_error(loss), 0.5);
}

TEST(SmoothingError, IsUnknownFromOneBlock) {
  const auto loss = smoothed_mean(noisy_blocks(1, 1));
  EXPECT_EQ(loss.block_modes.cols(), 0);
  EXPECT_TRUE(standard_error(loss).array().isNaN().all());
  EXPECT_TRUE(std::isnan(peak_error(loss)));
  EXPECT_THROW(static_cast<void>(rate_replicates(loss, 3, 1, ReplicateOf::noise_and_bias)),
               InputError);
}

// Smoothing neither makes nor hides what the blocks differ by in total.
TEST(SmoothingError, KeepsTheErrorOfTheTotal) {
  const auto blocks = noisy_blocks(8, 2);
  const auto loss = smoothed_mean(blocks);
  const Eigen::RowVectorXd totals = blocks.colwise().sum();
  const double by_hand = std::sqrt((totals.array() - totals.mean()).square().sum() / (8.0 * 7.0));
  EXPECT_NEAR(loss.block_modes.colwise().sum().norm() / by_hand, 1.0, 1e-12);
  EXPECT_LT(loss.bias_modes.colwise().sum().norm(), 1e-12 * by_hand);
}

// Against the scatter of many measurements of the same load: the blocks' part is that of the noise.
TEST(SmoothingError, IsTheScatterOfManyMeasurements) {
  constexpr int measurements = 200;
  Eigen::MatrixXd rates(bins, measurements);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(bins);
  for (int i = 0; i < measurements; ++i) {
    const auto loss = smoothed_mean(noisy_blocks(20, static_cast<unsigned>(i)));
    rates.col(i) = loss.rate.values;
    variance += loss.block_modes.rowwise().squaredNorm() / measurements;
  }
  const Eigen::VectorXd mean = rates.rowwise().mean();
  const double scatter = (rates.colwise() - mean).squaredNorm() / bins / (measurements - 1);
  EXPECT_NEAR(variance.mean() / scatter, 1.0, 0.15);
}

TEST(SmoothingError, IsNoneWhereNothingTouched) {
  auto blocks = noisy_blocks(8, 4);
  blocks.middleRows(40, 30).setZero();
  const auto loss = smoothed_mean(blocks);
  EXPECT_EQ(standard_error(loss).segment(41, 28).maxCoeff(), 0.0);
  EXPECT_GT(standard_error(loss).head(39).minCoeff(), 0.0);
}

TEST(SmoothingError, OfNoLossIsNone) {
  const auto loss = smoothed(edges, Eigen::VectorXd::Zero(bins), Eigen::MatrixXd::Zero(bins, 4));
  EXPECT_EQ(standard_error(loss).maxCoeff(), 0.0);
  EXPECT_TRUE(std::isnan(peak_error(loss)));
}

// Student's t of 7 degrees of freedom has the variance 7/5.
TEST(RateReplicates, HaveTheCovarianceOfTheModes) {
  const auto loss = smoothed_mean(noisy_blocks(8, 5));
  const Eigen::MatrixXd replicates = rate_replicates(loss, 20000, 9, ReplicateOf::noise_and_bias);
  const Eigen::VectorXd expected = 7.0 / 5.0 * loss.block_modes.rowwise().squaredNorm() +
                                   loss.bias_modes.rowwise().squaredNorm();
  const Eigen::VectorXd found = replicates.rowwise().squaredNorm() / 20000.0;
  EXPECT_LT((found.array() / expected.array() - 1.0).abs().maxCoeff(), 0.1);
  EXPECT_LT(replicates.rowwise().mean().cwiseAbs().cwiseQuotient(expected.cwiseSqrt()).maxCoeff(),
            5.0 / std::sqrt(20000.0));
}

TEST(RateReplicates, AreTheSameFromTheSameSeed) {
  const auto loss = smoothed_mean(noisy_blocks(5, 6));
  const Eigen::MatrixXd ten = rate_replicates(loss, 10, 3, ReplicateOf::noise_and_bias);
  EXPECT_EQ(ten, rate_replicates(loss, 10, 3, ReplicateOf::noise_and_bias));
  EXPECT_LT((ten.leftCols(4) - rate_replicates(loss, 4, 3, ReplicateOf::noise_and_bias)).norm(),
            1e-12 * ten.norm());
  EXPECT_NE(ten, rate_replicates(loss, 10, 4, ReplicateOf::noise_and_bias));
}

}  // namespace
}  // namespace millwear::wear
