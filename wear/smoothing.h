#pragma once
#include <Eigen/Core>

#include "wear/arc_curve.h"

namespace millwear::wear {

/// A wear depth rate smoothed along the profile, and what is not known of it. Its covariance is
/// that of two sums of modes: block_modes * block_modes^T (from as many blocks as columns, one
/// degree of freedom less) plus bias_modes * bias_modes^T (normal).
struct SmoothedLoss {
  ArcCurve rate;       ///< as the input: at the bins' centres, and between them
  double moved_share;  ///< sum |after - before| width / 2 over sum before width, 0 ... 1
  double strength;     ///< lambda of the penalty chosen by GCV; 0 where nothing was to smooth
  /// Bins x blocks [m/s]: the smoothed deviation of every time block from their mean, times
  /// 1 / sqrt(blocks (blocks - 1)). No columns with fewer than two blocks.
  Eigen::MatrixXd block_modes;
  /// Bins x modes [m/s]: what smoothing itself may have moved. No columns with fewer than two
  /// blocks.
  Eigen::MatrixXd bias_modes;
};

/// Smooths the sampled loss along the profile: a periodic cubic B-spline with a coefficient for
/// every two bins (at most 128), c minimising
///     sum w_i (y_i - sum_j B_j(s_i) c_j)^2 + lambda^2 sum_j (c_(j-1) - 2 c_j + c_(j+1))^2,
/// lambda by generalised cross-validation. With a `resolution` [m] the coefficients are no closer
/// than that: particles that stay locked in place while a pocket rises load the same spots
/// together, noise that cross-validation takes for structure. The weight of a bin is 1 / variance
/// of its mean over the time blocks, the variance averaged over the bin and two neighbours on each
/// side and not below a hundredth of the mean variance; with fewer than two blocks all bins weigh
/// the same.
///
/// What the spline then has to keep to: it is cut at zero; inside a stretch of three or more bins
/// with no loss it is zero but for one bin at each end, so no steel is lost where nothing touched;
/// and it is scaled so that sum(rate * width) is that of the input to 1e-12.
///
/// Errors: for its lambda the fit is linear, H y, and every block goes through the same H; the
/// scaling is taken along to first order, so a column of `block_modes` sums to what its block
/// deviates in total. The bias is Nychka's: with sigma^2 from the residuals,
///     sigma^2 [B (B^T W B + lambda^2 P)^-1 B^T - H W^-1 H^T],
/// Wahba's Bayesian covariance less that of the noise alone. Places without loss have no error.
///
/// `rate` has one value per bin (at least 8, none negative), `by_block` bins x blocks; `bin_edges`
/// even. Source: Eilers and Marx (1996), Statistical Science 11, 89; Golub, Heath and Wahba (1979),
/// Technometrics 21, 215; Nychka (1988), J. Am. Stat. Assoc. 83, 1134. Throws InputError for sizes
/// that do not fit and negative rates, and ResultRejected where the fit fails.
[[nodiscard]] SmoothedLoss smoothed(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                                    const Eigen::MatrixXd& by_block, double resolution = 0.0);

}  // namespace millwear::wear
