#include "wear/rate/smoothing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "wear/numerics/paper_spline.h"
#include "wear/numerics/whittaker_smoother.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index fewest_bins = 8;
/// A bin with less of the ball's way counts as untouched.
constexpr double least_path = 0.1;
/// Weight of a bin in the shadow, of the mean of all.
constexpr double shadow_weight = 1e-3;
constexpr Eigen::Index variance_half_width = 2;
constexpr Eigen::Index widest_peak_half_width = 2;
constexpr double variance_floor = 0.01;
constexpr Eigen::Index shortest_unloaded_stretch = 3;
constexpr double even_to = 1e-6;
/// Of squares of values up to 1.
constexpr double rounding = 1e-24;

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

/// 1 where the ball touches, else 0.
Eigen::ArrayXd touched(const Eigen::VectorXd& path) {
  return (path.array() >= least_path).cast<double>();
}

/// Of the loss per way. A bin's count of contacts, and so its variance, goes with its way.
Eigen::VectorXd weights_from(const Eigen::MatrixXd& deviations, const Eigen::VectorXd& path) {
  const Eigen::ArrayXd counts = touched(path);
  const Eigen::ArrayXd variance =
      deviations.rowwise().squaredNorm().array() * path.array() * counts;
  const double typical = variance.sum() / counts.sum();
  Eigen::VectorXd weights = path;
  if (typical > rounding) {
    const Eigen::ArrayXd among = periodic_mean(counts.matrix(), variance_half_width).array();
    const Eigen::ArrayXd mean =
        periodic_mean(variance.matrix(), variance_half_width).array() / among.max(1e-9);
    weights.array() *= typical / mean.max(variance_floor * typical);
  }
  return (counts > 0.0).select(weights, shadow_weight * weights.mean());
}

/// From each bin's centre to the next along the way of the ball's centre, in bins.
Eigen::VectorXd spacing_of(const Eigen::VectorXd& path) {
  const Eigen::VectorXd way = path.cwiseMax(least_path);
  Eigen::VectorXd next(way.size());
  next << way.tail(way.size() - 1), way[0];
  return 0.5 * (way + next);
}

/// 1 where steel may be lost: bins with loss, their neighbours, and gaps too short to count. All
/// of them are touched.
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

std::vector<Eigen::Index> touched_bins(const Eigen::VectorXd& path) {
  std::vector<Eigen::Index> bins;
  for (Eigen::Index bin = 0; bin < path.size(); ++bin)
    if (path[bin] >= least_path) bins.push_back(bin);
  return bins;
}

/// `loaded_places` where some bins are not touched: these are neither loaded nor a gap.
Eigen::ArrayXd loaded_places(const Eigen::VectorXd& rate, const std::vector<Eigen::Index>& bins) {
  Eigen::ArrayXd loaded = Eigen::ArrayXd::Zero(rate.size());
  loaded(bins) = loaded_places(rate(bins));
  return loaded;
}

/// Keeps the values of the touched bins and gives every other the line between those beside it.
Eigen::MatrixXd across_shadows(Eigen::Index count, const std::vector<Eigen::Index>& bins) {
  Eigen::MatrixXd across = Eigen::MatrixXd::Zero(count, count);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const Eigen::Index from = bins[i];
    const Eigen::Index to = bins[(i + 1) % bins.size()];
    const Eigen::Index gap = (to - from + count - 1) % count + 1;
    for (Eigen::Index k = 0; k < gap; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(gap);
      across((from + k) % count, from) += 1.0 - share;
      across((from + k) % count, to) += share;
    }
  }
  return across;
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

/// How a fit becomes the result: cut to the loaded places, laid across the shadows, and scaled so
/// that its sum is that of the data.
struct Finish {
  Eigen::ArrayXd loaded;
  Eigen::MatrixXd across;
  double scale;

  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& fit) const {
    return scale * (across * (fit.array().colwise() * loaded).matrix());
  }
};

/// What becomes of deviations of a fit, to first order: a deviation of the data that sums to `sums`
/// makes one of the result that sums to the same.
Eigen::MatrixXd finished_deviations(const Eigen::MatrixXd& deviations, const Finish& finish,
                                    const Eigen::VectorXd& result, const Eigen::VectorXd& path,
                                    const Eigen::RowVectorXd& sums) {
  const Eigen::MatrixXd cut = finish(deviations);
  return cut + result / path.dot(result) * (sums - path.transpose() * cut);
}

/// lambda that halves waves of twice the resolution, of values that lie `spacing` apart.
double least_strength(double spacing, double resolution) {
  return std::pow(resolution / (std::numbers::pi * spacing), 2);
}

LinearSmoother smoother_for(const Eigen::VectorXd& rate, const Eigen::MatrixXd& deviations,
                            const Smoothing& how, double bin_width) {
  switch (how.method) {
    case SmoothingMethod::penalised: {
      const Eigen::VectorXd spacing = spacing_of(how.centre_path);
      return whittaker_smoother(rate, weights_from(deviations, how.centre_path), deviations,
                                spacing,
                                least_strength(bin_width * spacing.mean(), how.resolution));
    }
    case SmoothingMethod::paper:
      return paper_spline(rate.size());
  }
  throw std::logic_error("a smoothing of no kind");
}

/// With a way over every bin: as long as the bin where none was given, and for `paper`.
Smoothing with_path(Smoothing how, Eigen::Index bins) {
  const bool is_given = how.centre_path.size() > 0 && how.method == SmoothingMethod::penalised;
  if (!is_given) how.centre_path = Eigen::VectorXd::Ones(bins);
  expect(how.centre_path.size() == bins && how.centre_path.maxCoeff() >= least_path,
         "every bin of a load has a way of the ball's centre, and one is touched");
  return how;
}

}  // namespace

SmoothedLoss smoothed(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                      const Eigen::MatrixXd& by_block, const Smoothing& smoothing) {
  check(bin_edges, rate, by_block);
  const Eigen::Index bins = rate.size();
  const Smoothing how = with_path(smoothing, bins);
  const Eigen::VectorXd& path = how.centre_path;
  const Eigen::MatrixXd deviations = deviations_of(by_block);
  const double before = rate.sum();
  if (before == 0.0) {
    return {{bin_edges, rate},
            path,
            rate,
            0.0,
            0.0,
            Eigen::MatrixXd::Zero(bins, deviations.cols()),
            Eigen::MatrixXd(bins, 0)};
  }
  const Eigen::VectorXd shares = path.cwiseMax(least_path).cwiseInverse() / rate.maxCoeff();
  const double unit = rate.maxCoeff();
  const Eigen::VectorXd per_path = shares.cwiseProduct(rate);
  const Eigen::MatrixXd per_path_deviations = shares.asDiagonal() * deviations;
  const auto smoother =
      smoother_for(per_path, per_path_deviations, how, bin_edges[1] - bin_edges[0]);
  const auto touched_places = touched_bins(path);
  Finish finish{loaded_places(rate, touched_places), across_shadows(bins, touched_places), unit};
  Eigen::VectorXd after = finish((smoother.hat * per_path).cwiseMax(0.0));
  const double scaling = before / path.dot(after);
  if (!(scaling > 0.0 && std::isfinite(scaling)))
    throw ResultRejected("smoothing left nothing of the load");
  after *= scaling;
  finish.scale *= scaling;
  const Eigen::VectorXd smooth_rate = path.cwiseProduct(after);
  const double moved = 0.5 * (smooth_rate - rate).lpNorm<1>() / before;
  if (deviations.cols() == 0)
    return {{bin_edges, smooth_rate}, path,       after,     moved,
            smoother.strength,        deviations, deviations};
  const Eigen::MatrixXd noise = smoother.hat * per_path_deviations;
  const Eigen::MatrixXd bias = bias_of(smoother, per_path, per_path_deviations);
  return {{bin_edges, smooth_rate},
          path,
          after,
          moved,
          smoother.strength,
          finished_deviations(noise, finish, after, path, deviations.colwise().sum()),
          finished_deviations(bias, finish, after, path, Eigen::RowVectorXd::Zero(bias.cols()))};
}

}  // namespace millwear::wear
