#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// A smoother as it acts on values at the centres of the even bins of one period:
/// smooth = hat * values, and what it may move of a load that it was not told of.
struct LinearSmoother {
  Eigen::MatrixXd hat;         ///< H, bins x bins
  double strength;             ///< lambda of the penalty; 0 for a smoother without
  Eigen::MatrixXd bias_modes;  ///< bins x modes of independent standard normal amplitudes
};

}  // namespace millwear::wear
