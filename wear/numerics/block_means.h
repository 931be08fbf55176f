#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear::wear {

/// Means of a series over `blocks` consecutive equal parts, size `blocks`; what is left over at its
/// end is in none. Empty where the series has fewer values than that.
[[nodiscard]] Eigen::VectorXd block_means(const std::vector<double>& series, int blocks);

/// Standard error of the mean over the blocks (columns), by row; NaN for fewer than two blocks.
[[nodiscard]] Eigen::VectorXd error_of_mean(const Eigen::MatrixXd& by_block);

}  // namespace millwear::wear
