#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// The x that minimises |design x - data|^2 with no component below zero, size design.cols().
///
/// The active-set method: every component is either zero or free, and one after another is freed
/// where that lowers the sum. Columns that are zero, or that those already free make up to 1e-10,
/// stay at zero: of two equal columns one gets all. Weighted data: divide every row of both by its
/// standard error. Sizes agree and all values are finite (std::logic_error).
/// Source: Lawson and Hanson (1974), Solving Least Squares Problems, chapter 23.
[[nodiscard]] Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& design,
                                                         const Eigen::VectorXd& data);

/// Covariance of the components of an unconstrained least-squares fit to data of standard error 1,
/// (design^T design)^-1. NaN throughout where the columns are dependent: condition number of the
/// design, with its columns scaled to length 1, above 1e8.
[[nodiscard]] Eigen::MatrixXd covariance_of_fit(const Eigen::MatrixXd& design);

/// Largest over least singular value of the design with its columns scaled to length 1; infinite
/// where a column is zero or there are fewer rows than columns.
[[nodiscard]] double condition_number(const Eigen::MatrixXd& design);

}  // namespace millwear::wear
