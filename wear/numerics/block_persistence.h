#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// By how much the variance of a mean over consecutive time blocks exceeds that of blocks which
/// know nothing of each other. What lies packed between the lifters keeps its place for longer than
/// a block, so neighbouring blocks resemble each other. With the deviations taken as a first-order
/// autoregression of one lag correlation rho for all places,
///     (1 + rho) / (1 - rho),     rho = (r + 1/n) / (1 - 3/n), cut to 0 ... 0.8,
/// r being the lag-one correlation of `by_block` (places x blocks) summed over twelve even
/// stretches, pooled over them by their variance; the correction is for the mean being their own
/// (Kendall 1954, Biometrika 41, 403). 1 for fewer than eight blocks, which cannot tell.
[[nodiscard]] double persistence(const Eigen::MatrixXd& by_block);

/// The blocks with their deviations from the mean widened by the root of it: replicates that
/// scatter as independent ones would, with the same mean.
[[nodiscard]] Eigen::MatrixXd as_independent(const Eigen::MatrixXd& by_block);

}  // namespace millwear::wear
