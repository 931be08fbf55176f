#pragma once
#include <Eigen/Core>

#include "mill/case/wear_settings.h"
#include "wear/numerics/arc_curve.h"

namespace millwear::wear {

/// How a load is smoothed.
struct Smoothing {
  SmoothingMethod method = SmoothingMethod::penalised;
  /// With `penalised`: waves of twice this length [m] are halved at least.
  double resolution = 0.0;
  /// With `penalised`: of every bin, see wear/surface/centre_path.h. Empty: 1 everywhere.
  Eigen::VectorXd centre_path = {};
};

/// A wear depth rate smoothed along the profile, and what is not known of it. The covariance of
/// `per_path` is that of two sums of modes: block_modes * block_modes^T (from as many blocks as
/// columns, one degree of freedom less) plus bias_modes * bias_modes^T (normal).
struct SmoothedLoss {
  ArcCurve rate;             ///< as the input: at the bins' centres, and between them
  Eigen::VectorXd path;      ///< of the ball's centre over every bin / its width [-]
  Eigen::VectorXd per_path;  ///< rate / path, on from where there is none [m/s]
  double moved_share;        ///< sum |after - before| width / 2 over sum before width, 0 ... 1
  double strength;  ///< lambda of the penalty; 0 where nothing was to smooth or without one
  /// Bins x blocks [m/s]: the smoothed deviation of every time block from their mean, times
  /// 1 / sqrt(blocks (blocks - 1)). No columns with fewer than two blocks.
  Eigen::MatrixXd block_modes;
  /// Bins x modes [m/s]: what smoothing itself may have moved. No columns with fewer than two
  /// blocks.
  Eigen::MatrixXd bias_modes;
};

/// Smooths the sampled loss along the profile, `penalised` or as the 2006 `paper` does.
///
/// `penalised`: wear/numerics/whittaker_smoother.h on the loss per way of the ball's centre, along
/// that way: an edge has a long way of its own, so its load stays there. Waves shorter than the
/// resolution allows are no structure: particles that stay locked in place while a pocket rises
/// load the same spots together, noise that cross-validation takes for structure. The weight of a
/// bin is its way / variance, the variance that of its mean over the time blocks per way, averaged
/// over the bin and two neighbours on each side and not below a hundredth of the mean of all; with
/// fewer than two blocks all bins weigh as their ways. A bin that the ball does not touch says
/// nothing: its value lies on the line between the touched bins beside it.
/// `paper`: wear/numerics/paper_spline.h, on the loss itself.
///
/// What the curve then has to keep to: it is cut at zero; inside a stretch of three or more touched
/// bins with no loss it is zero but for one bin at each end, so no steel is lost where nothing
/// touched;
/// and it is scaled so that sum(rate * width) is that of the input to 1e-12.
///
/// Errors: the smoother is linear, H y, and every block goes through the same H; the scaling is
/// taken along to first order, so a column of `block_modes` sums to what its block deviates in
/// total (times the way). The bias is that of the smoother (see there) and one mode more for what
/// is sharper than it: the residuals y - H y, averaged over 1, 3 and 5 bins, as far as their
/// squares exceed the variance that the blocks give them, the largest of the three at every bin.
/// Places without loss have no error.
///
/// `rate` has one value per bin (at least 8, none negative), `by_block` bins x blocks; `bin_edges`
/// even. Sizes agree (std::logic_error). Throws ResultRejected where the fit fails.
[[nodiscard]] SmoothedLoss smoothed(const Eigen::VectorXd& bin_edges, const Eigen::VectorXd& rate,
                                    const Eigen::MatrixXd& by_block, const Smoothing& how = {});

}  // namespace millwear::wear
