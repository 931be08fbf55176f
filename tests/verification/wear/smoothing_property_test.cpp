#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "wear/numerics/random_stream.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::wear {
namespace {

/// Rates of some blocks with one unloaded stretch of three bins or more.
struct SampledLoad {
  Eigen::VectorXd edges;
  Eigen::MatrixXd by_block;
  Eigen::Index unloaded_from;
  Eigen::Index unloaded_bins;

  [[nodiscard]] Eigen::VectorXd rate() const { return by_block.rowwise().mean(); }
};

/// Bins a multiple of 32, so that both splines have an even number of bins to the break point.
SampledLoad sampled_load() {
  const Eigen::Index bins = 32 * *rc::gen::inRange<Eigen::Index>(2, 6);
  const auto blocks = *rc::gen::inRange<Eigen::Index>(2, 12);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto from = *rc::gen::inRange<Eigen::Index>(0, bins - 20);
  const auto size = *rc::gen::inRange<Eigen::Index>(3, 20);
  SampledLoad load{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, 0.6),
                   standard_normals(bins, blocks, seed).array().exp(), from, size};
  for (Eigen::Index bin = 0; bin < bins; ++bin)
    load.by_block.row(bin) *=
        1.0 + std::cos(2.0 * std::numbers::pi * (static_cast<double>(bin) + 0.5) /
                       static_cast<double>(bins));
  load.by_block.middleRows(from, size).setZero();
  return load;
}

Smoothing any_smoothing() {
  return {*rc::gen::element(SmoothingMethod::penalised, SmoothingMethod::paper), 0.0};
}

SmoothedLoss smoothed_load(const SampledLoad& load, const Smoothing& how) {
  return smoothed(load.edges, load.rate(), load.by_block, how);
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

RC_GTEST_PROP(SmoothingProperties, Conserves, ()) {
  const auto load = sampled_load();
  const auto loss = smoothed_load(load, any_smoothing());
  const double total = load.rate().sum();
  RC_ASSERT(std::abs(loss.rate.values.sum() / total - 1.0) < 1e-6);
  RC_ASSERT(loss.rate.values.minCoeff() >= 0.0);
  RC_ASSERT(loss.bias_modes.colwise().sum().norm() < 1e-6 * total);
}

RC_GTEST_PROP(SmoothingProperties, LosesNothingWhereNoLoadTouched, ()) {
  const auto load = sampled_load();
  const auto loss = smoothed_load(load, any_smoothing());
  const Eigen::VectorXd error = standard_error(loss);
  for (Eigen::Index i = 1; i + 1 < load.unloaded_bins; ++i) {
    RC_ASSERT(loss.rate.values[load.unloaded_from + i] == 0.0);
    RC_ASSERT(error[load.unloaded_from + i] == 0.0);
  }
}

RC_GTEST_PROP(SmoothingProperties, IsTheSameInAMirror, ()) {
  const auto load = sampled_load();
  const auto how = any_smoothing();
  auto mirrored = load;
  mirrored.by_block = load.by_block.colwise().reverse();
  const auto here = smoothed_load(load, how);
  const auto there = smoothed_load(mirrored, how);
  RC_ASSERT(difference(there.rate.values.reverse(), here.rate.values) < 1e-6);
  RC_ASSERT(difference(standard_error(there).reverse(), standard_error(here)) < 1e-6);
}

// By whole distances of break points, which both splines have at a multiple of bins / 32.
RC_GTEST_PROP(SmoothingProperties, IsTheSameWhenBinsAreCountedFromElsewhere, ()) {
  const auto load = sampled_load();
  const auto how = any_smoothing();
  const Eigen::Index bins = load.by_block.rows();
  const Eigen::Index by = *rc::gen::inRange<Eigen::Index>(1, 16) * bins / 16;
  const auto turned = [&](const Eigen::MatrixXd& values) {
    Eigen::MatrixXd result(bins, values.cols());
    result << values.bottomRows(bins - by), values.topRows(by);
    return result;
  };
  auto elsewhere = load;
  elsewhere.by_block = turned(load.by_block);
  const auto here = smoothed_load(load, how);
  const auto there = smoothed_load(elsewhere, how);
  RC_ASSERT(difference(there.rate.values, turned(here.rate.values)) < 1e-6);
  RC_ASSERT(difference(standard_error(there), turned(standard_error(here))) < 1e-6);
}

RC_GTEST_PROP(SmoothingProperties, GoesWithTheScaleOfTheLoad, ()) {
  const auto load = sampled_load();
  const auto how = any_smoothing();
  const double scale = std::pow(10.0, *rc::gen::inRange(-15, 15));
  auto scaled = load;
  scaled.by_block *= scale;
  const auto here = smoothed_load(load, how);
  const auto there = smoothed_load(scaled, how);
  RC_ASSERT(difference(there.rate.values / scale, here.rate.values) < 1e-9);
  RC_ASSERT(difference(standard_error(there) / scale, standard_error(here)) < 1e-9);
  RC_ASSERT(std::abs(there.moved_share - here.moved_share) < 1e-9);
}

}  // namespace
}  // namespace millwear::wear
