#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// A fit and all that it does to values at the same abscissae. With the chosen strength the fit is
/// linear: values = H y, H = U diag(kept) U^T W, where the columns of U are the shapes that the
/// penalty tells apart (Demmler and Reinsch), U^T W U = 1, smoothest first.
struct PenalisedFit {
  Eigen::VectorXd values;   ///< of the spline at the abscissae of the data
  double strength;          ///< lambda
  Eigen::MatrixXd shapes;   ///< U, data x coefficients
  Eigen::VectorXd kept;     ///< share of each shape that the fit keeps, 0 ... 1
  Eigen::VectorXd weights;  ///< the diagonal of W
  double variance;          ///< of a datum of weight 1: weighted residuals / (data - trace H)
};

/// Weighted, penalised periodic cubic B-spline through values at the centres of even bins over one
/// period, with `coefficients` (>= 4, < values.size()) B-splines and the strength lambda of the
/// second-difference penalty chosen by generalised cross-validation. Weights are above zero.
/// Source: Demmler and Reinsch (1975), Numerische Mathematik 24, 375.
/// Throws ResultRejected with a reason where the fit fails.
[[nodiscard]] PenalisedFit fit_periodic_spline(const Eigen::VectorXd& values,
                                               const Eigen::VectorXd& weights,
                                               Eigen::Index coefficients);

/// H times each column: what the fit would have made of other values.
[[nodiscard]] Eigen::MatrixXd fitted(const PenalisedFit& fit, const Eigen::MatrixXd& columns);

}  // namespace millwear::wear
