#pragma once
#include <Eigen/Core>

namespace millwear::wear {

struct PenalisedFit {
  Eigen::VectorXd values;  ///< of the spline at the abscissae of the data
  double strength;         ///< lambda
};

/// Weighted, penalised periodic cubic B-spline through values at the centres of even bins over one
/// period, with `coefficients` (>= 4, < values.size()) B-splines and the strength lambda of the
/// second-difference penalty chosen by generalised cross-validation.
/// Throws ResultRejected with GSL's reason where the fit fails.
[[nodiscard]] PenalisedFit fit_periodic_spline(const Eigen::VectorXd& values,
                                               const Eigen::VectorXd& weights,
                                               Eigen::Index coefficients);

}  // namespace millwear::wear
