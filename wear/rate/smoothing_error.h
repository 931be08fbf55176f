#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "wear/rate/smoothing.h"

namespace millwear::wear {

/// Standard error of the smoothed rate at every bin [m/s]: the root of the diagonal of its
/// covariance. NaN with fewer than two blocks.
[[nodiscard]] Eigen::VectorXd standard_error(const SmoothedLoss& loss);

/// The largest relative standard error of the smoothed rate over its peaks [-]: local maxima of the
/// rate per way of the ball's centre, above half of the greatest. Only the noise of the blocks
/// counts: a longer measurement makes this less, while a peak that is sharper than the smoothing
/// stays lowered. NaN with fewer than two blocks, or no loss.
[[nodiscard]] double peak_error(const SmoothedLoss& loss);

/// What a replicate of a rate contains.
enum class ReplicateOf {
  noise,           ///< of the measurement: what another one of the same length may have shown
  noise_and_bias,  ///< and what smoothing may have moved, which all measurements share
};

/// Deviations from the smoothed rate per way of the ball's centre, bins x count [m/s]: replicate r
/// is
///     sum over blocks z_rb block_modes_b sqrt((B - 1) / chi2_r) + sum over modes z_rm bias_modes_m
/// (the second sum with `noise_and_bias` only) with standard normal z and chi2_r of B - 1 degrees
/// of freedom, so that few blocks give the wide tails of Student's distribution. A rate with its
/// deviation may be below zero: cut it there. The same seed gives the same bytes, and the first
/// replicates do not depend on their count. Throws InputError with fewer than two blocks.
[[nodiscard]] Eigen::MatrixXd rate_replicates(const SmoothedLoss& loss, Eigen::Index count,
                                              std::uint64_t seed, ReplicateOf what);

}  // namespace millwear::wear
