#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// The uniform periodic cubic B-splines of period 1, `coefficients` (>= 4) of them, at the centres
/// of `places` equal parts of the period: places x coefficients. Rows sum to 1.
/// Throws ResultRejected with GSL's reason where that fails.
[[nodiscard]] Eigen::MatrixXd periodic_splines(Eigen::Index places, Eigen::Index coefficients);

}  // namespace millwear::wear
