#pragma once
#include <Eigen/Core>

#include "wear/numerics/linear_smoother.h"

namespace millwear::wear {

/// The weighted, penalised periodic cubic B-spline B with `coefficients` (>= 4, < values.size())
/// coefficients, c minimising
///     sum w_i (y_i - sum_j B_j(s_i) c_j)^2 + lambda^2 sum_j (c_(j-1) - 2 c_j + c_(j+1))^2,
/// which is linear in y: H = B (B^T W B + lambda^2 P)^-1 B^T W.
///
/// lambda is the larger of two: that of generalised cross-validation, and that which leaves the
/// least risk when the noise is what the blocks differ by,
///     sum w_i (y_i - (H y)_i)^2 + 2 sum over blocks of d_b^T W H d_b,
/// d_b the columns of `deviations` (bins x blocks, d_b d_b^T summing to the covariance of
/// `values`): the leave-one-block-out cross-validation of the mean. The first holds noise of
/// neighbouring bins for independent, the second that of the blocks; where either is wrong its
/// lambda is too small. Without deviations the first alone decides.
///
/// The bias modes are U diag(sigma sqrt(k (1 - k))) with the penalty's own shapes U, H = U diag(k)
/// U^T W: Wahba's Bayesian covariance less the frequentist one. sigma^2 is the variance that the
/// blocks show of the shapes, weighted with k (1 - k).
///
/// Weights are above zero. Sources: Eilers and Marx (1996), Statistical Science 11, 89; Golub,
/// Heath and Wahba (1979), Technometrics 21, 215; Mallows (1973), Technometrics 15, 661; Demmler
/// and Reinsch (1975), Numerische Mathematik 24, 375; Nychka (1988), J. Am. Stat. Assoc. 83, 1134.
/// Throws ResultRejected with a reason where the fit fails.
[[nodiscard]] LinearSmoother penalised_spline(const Eigen::VectorXd& values,
                                              const Eigen::VectorXd& weights,
                                              const Eigen::MatrixXd& deviations,
                                              Eigen::Index coefficients);

}  // namespace millwear::wear
