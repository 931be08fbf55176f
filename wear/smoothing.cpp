#include "wear/smoothing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/failure.h"
#include "wear/penalised_spline.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index fewest_bins = 8;
constexpr Eigen::Index fewest_coefficients = 4;
constexpr Eigen::Index most_coefficients = 128;
constexpr Eigen::Index variance_half_width = 2;
constexpr double variance_floor = 0.01;
constexpr Eigen::Index shortest_unloaded_stretch = 3;
constexpr double even_to = 1e-6;

void check(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
           const Eigen::MatrixXd& by_block) {
  const Eigen::Index bins = rate.size();
  if (bins < fewest_bins || bin_edges.size() != bins + 1 || by_block.rows() != bins) {
    throw InputError(fmt::format(
        "smoothing needs {} bins or more, an edge more than bins, and blocks of as many bins; it "
        "got {}, {} and {}",
        fewest_bins, bins, bin_edges.size(), by_block.rows()));
  }
  const Eigen::ArrayXd widths = bin_edges.tail(bins) - bin_edges.head(bins);
  if (!(widths.maxCoeff() - widths.minCoeff() <= even_to * widths.mean())) {
    throw InputError("smoothing needs bins of equal width");
  }
  if (!rate.allFinite() || rate.minCoeff() < 0.0) {
    throw InputError("a wear rate is negative or not finite");
  }
}

Eigen::VectorXd periodic_mean(const Eigen::VectorXd& values, Eigen::Index half_width) {
  const Eigen::Index n = values.size();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = -half_width; j <= half_width; ++j) {
      mean[i] += values[(i + j + n) % n];
    }
  }
  return mean / static_cast<double>(2 * half_width + 1);
}

/// Deviation of every block from their mean, so that the sum of squares is the mean's variance.
Eigen::MatrixXd deviations_of(const Eigen::MatrixXd& by_block) {
  const auto blocks = static_cast<double>(by_block.cols());
  const Eigen::VectorXd mean = by_block.rowwise().mean();
  return (by_block.colwise() - mean) / std::sqrt(blocks * (blocks - 1.0));
}

Eigen::VectorXd weights_from(const Eigen::MatrixXd& by_block) {
  if (by_block.cols() < 2) return Eigen::VectorXd::Ones(by_block.rows());
  const Eigen::VectorXd variance = deviations_of(by_block).rowwise().squaredNorm();
  const double typical = variance.mean();
  if (!(typical > 0.0)) return Eigen::VectorXd::Ones(by_block.rows());
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

/// Shapes of the bias: U diag(sigma sqrt(k (1 - k))), k the share of each shape that the fit keeps.
Eigen::MatrixXd bias_of(const PenalisedFit& fit) {
  const Eigen::ArrayXd spread =
      (fit.variance * fit.kept.array() * (1.0 - fit.kept.array())).max(0.0).sqrt();
  const Eigen::Index most = fit.kept.size() - 1;
  return fit.shapes.rightCols(most) * spread.tail(most).matrix().asDiagonal();
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

}  // namespace

SmoothedLoss smoothed(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                      const Eigen::MatrixXd& by_block, double resolution) {
  check(bin_edges, rate, by_block);
  const Eigen::Index bins = rate.size();
  const Eigen::Index blocks = by_block.cols();
  const Eigen::Index replicates = blocks < 2 ? 0 : blocks;
  const double before = rate.sum();
  if (before == 0.0) {
    return {{bin_edges, rate},
            0.0,
            0.0,
            Eigen::MatrixXd::Zero(bins, replicates),
            Eigen::MatrixXd::Zero(bins, 0)};
  }
  const Eigen::Index coefficients = coefficients_for(bin_edges, resolution);
  const double scale = rate.maxCoeff();
  const auto fit = fit_periodic_spline(rate / scale, weights_from(by_block), coefficients);
  const Eigen::ArrayXd loaded = loaded_places(rate);
  Eigen::VectorXd after = scale * fit.values.array().max(0.0) * loaded;
  if (!(after.sum() > 0.0)) throw ResultRejected("smoothing left nothing of the load");
  const double scaling = before / after.sum();
  after *= scaling;
  const double moved = 0.5 * (after - rate).lpNorm<1>() / before;
  if (replicates == 0) {
    const Eigen::MatrixXd unknown(bins, 0);
    return {{bin_edges, after}, moved, fit.strength, unknown, unknown};
  }
  const Eigen::MatrixXd deviations = deviations_of(by_block);
  const Eigen::MatrixXd bias = scale * bias_of(fit);
  return {
      {bin_edges, after},
      moved,
      fit.strength,
      cut_and_scaled(fitted(fit, deviations), loaded, scaling, after, deviations.colwise().sum()),
      cut_and_scaled(bias, loaded, scaling, after, Eigen::RowVectorXd::Zero(bias.cols()))};
}

}  // namespace millwear::wear
