#include "wear/rate/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 200;
constexpr Eigen::Index blocks = 20;
const Eigen::VectorXd edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, 0.8);

const Eigen::VectorXd truth = Eigen::VectorXd::NullaryExpr(bins, [](Eigen::Index bin) {
  const double place = 2.0 * std::numbers::pi * (static_cast<double>(bin) + 0.5) / bins;
  return 2.0 + std::sin(place) + 0.5 * std::cos(3.0 * place);
});

/// The truth with independent normal noise of `sigma` on the mean over the blocks.
Eigen::MatrixXd noisy_blocks(double sigma, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sigma * std::sqrt(static_cast<double>(blocks)));
  return Eigen::MatrixXd::NullaryExpr(bins, blocks,
                                      [&](auto bin, auto) { return truth[bin] + noise(random); });
}

double rms(const Eigen::VectorXd& error) { return std::sqrt(error.squaredNorm() / bins); }

TEST(Smoothing, TakesNoiseOffAKnownCurve) {
  double before = 0.0;
  double after = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto sample = noisy_blocks(0.2, seed);
    const Eigen::VectorXd rate = sample.rowwise().mean();
    before += rms(rate - truth) / 20.0;
    after += rms(smoothed(edges, rate, sample).rate.values - truth) / 20.0;
  }
  EXPECT_NEAR(before, 0.2, 0.01);
  RecordProperty("rms_after", std::to_string(after));
  EXPECT_LT(after, 0.06);
}

TEST(Smoothing, Conserves) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto sample = noisy_blocks(0.2, seed);
    const Eigen::VectorXd rate = sample.rowwise().mean();
    const auto smooth = smoothed(edges, rate, sample);
    EXPECT_NEAR(smooth.rate.values.sum() / rate.sum(), 1.0, 1e-12);
    EXPECT_GE(smooth.rate.values.minCoeff(), 0.0);
    EXPECT_NEAR(smooth.moved_share, 0.5 * (smooth.rate.values - rate).cwiseAbs().sum() / rate.sum(),
                1e-14);
  }
}

TEST(Smoothing, LeavesASmoothCurveAlone) {
  const auto smooth = smoothed(edges, truth, truth.replicate(1, blocks));
  EXPECT_LT(rms(smooth.rate.values - truth), 1e-3);
}

TEST(Smoothing, IsPeriodic) {
  const auto sample = noisy_blocks(0.2, 4);
  const Eigen::VectorXd rate = sample.rowwise().mean();
  const auto turned = [](const Eigen::MatrixXd& m) {
    Eigen::MatrixXd result(m.rows(), m.cols());
    result << m.bottomRows(m.rows() - 50), m.topRows(50);
    return result;
  };
  const auto here = smoothed(edges, rate, sample);
  const auto there = smoothed(edges, turned(rate), turned(sample));
  const Eigen::VectorXd expected = turned(here.rate.values);
  EXPECT_LT((there.rate.values - expected).cwiseAbs().maxCoeff(), 1e-4);
}

// Nothing touched bins 60 ... 139; smoothing may reach one bin into them from either side.
TEST(Smoothing, LeavesUnloadedStretchesUnworn) {
  auto sample = noisy_blocks(0.3, 2).cwiseMax(0.0).eval();
  sample.middleRows(60, 80).setZero();
  const Eigen::VectorXd rate = sample.rowwise().mean();
  const auto smooth = smoothed(edges, rate, sample);
  EXPECT_EQ(smooth.rate.values.segment(61, 78).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_NEAR(smooth.rate.values.sum() / rate.sum(), 1.0, 1e-12);
}

TEST(Smoothing, FillsAGapOfOneBin) {
  auto sample = noisy_blocks(0.1, 2);
  sample.row(100).setZero();
  const Eigen::VectorXd rate = sample.rowwise().mean();
  EXPECT_GT(smoothed(edges, rate, sample).rate.values[100], 0.5 * truth[100]);
}

// Ten times the noise on one half: the other half decides where they meet.
TEST(Smoothing, TrustsTheQuietBins) {
  auto sample = noisy_blocks(0.05, 3);
  const auto loud = noisy_blocks(0.5, 3);
  sample.topRows(100) = loud.topRows(100);
  const Eigen::VectorXd rate = sample.rowwise().mean();
  const auto weighted = smoothed(edges, rate, sample);
  const auto even = smoothed(edges, rate, rate);
  const auto error = [&](const SmoothedLoss& fit) {
    return (fit.rate.values - truth).tail(100).norm();
  };
  EXPECT_LT(error(weighted), error(even));
}

TEST(Smoothing, OfNoLoadIsNoLoad) {
  const auto smooth =
      smoothed(edges, Eigen::VectorXd::Zero(bins), Eigen::MatrixXd::Zero(bins, blocks));
  EXPECT_EQ(smooth.rate.values.norm(), 0.0);
  EXPECT_EQ(smooth.moved_share, 0.0);
}

TEST(Smoothing, RefusesWhatDoesNotFit) {
  EXPECT_THROW(static_cast<void>(smoothed(edges, truth, truth.head(50))), std::logic_error);
  EXPECT_THROW(static_cast<void>(smoothed(edges, -truth, truth)), std::logic_error);
  EXPECT_THROW(static_cast<void>(smoothed(edges.head(8), truth.head(7), truth.head(7))),
               std::logic_error);
}

}  // namespace
}  // namespace millwear::wear
