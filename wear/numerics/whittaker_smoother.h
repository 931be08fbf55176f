#pragma once
#include <Eigen/Core>

#include "wear/numerics/linear_smoother.h"

namespace millwear::wear {

/// Whittaker's smoother of a period of values: z minimising
///     sum w_i (y_i - z_i)^2 + lambda^2 h^3 sum ((z_(i+1) - z_i) / h_i - (z_i - z_(i-1)) /
///     h_(i-1))^2
///                                              / ((h_(i-1) + h_i) / 2),
/// h_i the `spacing` from value i to the next and h its mean, which is linear in y: z = H y. Even
/// values have sum (z_(i-1) - 2 z_i + z_(i+1))^2; with weights of 1 waves of 2 pi sqrt(lambda) h
/// are halved and longer ones pass.
///
/// lambda is the largest of three: `least_strength`, that of generalised cross-validation, and that
/// which leaves the least risk when the noise is what the blocks differ by,
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
/// Weights and spacing are above zero; a value of next to no weight is found from its neighbours.
/// Sources: Whittaker (1923), Proc. Edinburgh Math. Soc. 41, 63;
/// Eilers (2003), Analytical Chemistry 75, 3631; Golub, Heath and Wahba (1979), Technometrics 21,
/// 215; Mallows (1973), Technometrics 15, 661; Demmler and Reinsch (1975), Numerische Mathematik
/// 24, 375; Nychka (1988), J. Am. Stat. Assoc. 83, 1134.
/// Throws ResultRejected with a reason where the fit fails.
[[nodiscard]] LinearSmoother whittaker_smoother(const Eigen::VectorXd& values,
                                                const Eigen::VectorXd& weights,
                                                const Eigen::MatrixXd& deviations,
                                                const Eigen::VectorXd& spacing,
                                                double least_strength);

}  // namespace millwear::wear
