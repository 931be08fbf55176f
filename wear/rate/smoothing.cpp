#include "wear/rate/smoothing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "wear/numerics/paper_spline.h"
#include "wear/numerics/penalised_spline.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index fewest_bins = 8;
constexpr Eigen::Index fewest_coefficients = 4;
constexpr Eigen::Index most_coefficients = 128;
constexpr Eigen::Index variance_half_width = 2;
constexpr Eigen::Index widest_peak_half_width = 2;
constexpr double variance_floor = 0.01;
constexpr Eigen::Index shortest_unloaded_stretch = 3;
constexpr double even_to = 1e-6;

void check(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
           const Eigen::MatrixXd& by_block) {
  const Eigen::Index bins = rate.size();
  expect(
      bins >= fewest_bins && bin_edges.size() == bins + 1 && by_block.rows() == bins,
      "a rate that is smoothed has 8 bins or more, an edge more than bins, and blocks of as many "
      "bins");
  const Eigen::ArrayXd widths = bin_edges.tail(bins) - bin_edges.head(bins);
  expect(widths.maxCoeff() - widths.minCoeff() <= even_to * widths.mean(),
         "a rate is smoothed on bins of equal width");
  expect(rate.allFinite() && rate.minCoeff() >= 0.0, "a rate is finite and not negative");
}

/// Every column averaged over a bin and `half_width` neighbours on each side.
Eigen::MatrixXd periodic_mean(const Eigen::MatrixXd& values, Eigen::Index half_width) {
  const Eigen::Index n = values.rows();
  Eigen::MatrixXd sum = values;
  for (Eigen::Index shift = 1; shift <= half_width; ++shift) {
    sum.topRows(n - shift) += values.bottomRows(n - shift);
    sum.bottomRows(shift) += values.topRows(shift);
    sum.bottomRows(n - shift) += values.topRows(n - shift);
    sum.topRows(shift) += values.bottomRows(shift);
  }
  return sum / static_cast<double>(2 * half_width + 1);
}

/// Deviation of every block from their mean, so that the sum of squares is the mean's variance. No
/// columns with fewer than two blocks.
Eigen::MatrixXd deviations_of(const Eigen::MatrixXd& by_block) {
  if (by_block.cols() < 2) return Eigen::MatrixXd(by_block.rows(), 0);
  const auto blocks = static_cast<double>(by_block.cols());
  const Eigen::VectorXd mean = by_block.rowwise().mean();
  return (by_block.colwise() - mean) / std::sqrt(blocks * (blocks - 1.0));
}

Eigen::VectorXd weights_from(const Eigen::MatrixXd& deviations) {
  const Eigen::VectorXd variance = deviations.rowwise().squaredNorm();
  const double typical = variance.mean();
  if (!(typical > 0.0)) return Eigen::VectorXd::Ones(deviations.rows());
  return typical * periodic_mean(variance, variance_half_width)
                       .cwiseMax(variance_floor * typical)
                       .cwiseInverse();
}

/// 1 where steel may be lost: bins with loss, their neighbours, and gaps too short to count.
Eigen::ArrayXd loaded_places(const Eigen::VectorXd& rate) {
  const Eigen::Index n = rate.size();
  const auto loss_at = [&](Eigen::Index i) { return rate[(i % n + n) % n] > 0.0; };
  Eigen::ArrayXd loaded = Eigen::ArrayXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Index before = 0;
    Eigen::Index after = 0;
    while (before < shortest_unloaded_stretch && !loss_at(i - before)) ++before;
    while (after < shortest_unloaded_stretch && !loss_at(i + after)) ++after;
    const bool long_stretch = before + after - 1 >= shortest_unloaded_stretch;
    if (before >= 2 && after >= 2 && long_stretch) loaded[i] = 0.0;
  }
  return loaded;
}

/// What is left of the residuals where they are larger than their noise: peaks that are sharper
/// than the smoother.
Eigen::VectorXd sharper_than(const Eigen::MatrixXd& hat, const Eigen::VectorXd& rate,
                             const Eigen::MatrixXd& deviations) {
  const Eigen::VectorXd residual = rate - hat * rate;
  const Eigen::MatrixXd noise = deviations - hat * deviations;
  Eigen::ArrayXd mode = Eigen::ArrayXd::Zero(rate.size());
  for (Eigen::Index half_width = 0; half_width <= widest_peak_half_width; ++half_width) {
    const Eigen::ArrayXd mean = periodic_mean(residual, half_width).array();
    const Eigen::ArrayXd variance = periodic_mean(noise, half_width).rowwise().squaredNorm();
    const Eigen::ArrayXd excess = (mean.square() - variance).max(0.0).sqrt();
    mode = (excess > mode.abs()).select(mean.sign() * excess, mode);
  }
  return mode;
}

Eigen::MatrixXd bias_of(const LinearSmoother& smoother, const Eigen::VectorXd& rate,
                        const Eigen::MatrixXd& deviations) {
  Eigen::MatrixXd modes(rate.size(), smoother.bias_modes.cols() + 1);
  modes << smoother.bias_modes, sharper_than(smoother.hat, rate, deviations);
  return modes;
}

/// What becomes of deviations of a fit where the fit is cut to the loaded places and scaled by
/// `scale` so that its sum is that of the data, to first order: a deviation of the data that sums
/// to `sums` makes one of the result that sums to the same.
Eigen::MatrixXd cut_and_scaled(const Eigen::MatrixXd& deviations, const Eigen::ArrayXd& loaded,
                               double scale, const Eigen::VectorXd& result,
                               const Eigen::RowVectorXd& sums) {
  const Eigen::MatrixXd cut = scale * (deviations.array().colwise() * loaded).matrix();
  return cut + result / result.sum() * (sums - cut.colwise().sum());
}

Eigen::Index coefficients_for(const Eigen::VectorXd& bin_edges, double resolution) {
  const Eigen::Index bins = bin_edges.size() - 1;
  const double length = bin_edges[bins] - bin_edges[0];
  const auto resolved = resolution > 0.0 ? static_cast<Eigen::Index>(length / resolution) : bins;
  return std::clamp(resolved, fewest_coefficients, std::min(most_coefficients, bins / 2));
}

LinearSmoother smoother_for(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                            const Eigen::MatrixXd& deviations, const Smoothing& how) {
  switch (how.method) {
    case SmoothingMethod::penalised:
      return penalised_spline(rate, weights_from(deviations), deviations,
                              coefficients_for(bin_edges, how.resolution));
    case SmoothingMethod::paper:
      return paper_spline(rate.size());
  }
  throw std::logic_error("a smoothing of no kind");
}

}  // namespace

SmoothedLoss smoothed(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                      const Eigen::MatrixXd& by_block, const Smoothing& how) {
  check(bin_edges, rate, by_block);
  const Eigen::Index bins = rate.size();
  const Eigen::MatrixXd deviations = deviations_of(by_block);
  const double before = rate.sum();
  if (before == 0.0) {
    return {{bin_edges, rate},
            0.0,
            0.0,
            Eigen::MatrixXd::Zero(bins, deviations.cols()),
            Eigen::MatrixXd(bins, 0)};
  }
  const double unit = rate.maxCoeff();
  const auto smoother = smoother_for(bin_edges, rate / unit, deviations / unit, how);
  const Eigen::ArrayXd loaded = loaded_places(rate);
  Eigen::VectorXd after = (smoother.hat * rate).array().max(0.0) * loaded;
  const double scaling = before / after.sum();
  if (!(scaling > 0.0 && std::isfinite(scaling)))
    throw ResultRejected("smoothing left nothing of the load");
  after *= scaling;
  const double moved = 0.5 * (after - rate).lpNorm<1>() / before;
  if (deviations.cols() == 0)
    return {{bin_edges, after}, moved, smoother.strength, deviations, deviations};
  const Eigen::MatrixXd noise = smoother.hat * deviations;
  const Eigen::MatrixXd bias = unit * bias_of(smoother, rate / unit, deviations / unit);
  return {{bin_edges, after},
          moved,
          smoother.strength,
          cut_and_scaled(noise, loaded, scaling, after, deviations.colwise().sum()),
          cut_and_scaled(bias, loaded, scaling, after, Eigen::RowVectorXd::Zero(bias.cols()))};
}

}  // namespace millwear::wear
