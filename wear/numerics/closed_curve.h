#pragma once
#include <Eigen/Core>
#include <optional>

namespace millwear::wear {

/// Values at equal steps around a circle: behind the last comes the first.

/// The index of a step, however often it has gone around.
[[nodiscard]] Eigen::Index around(Eigen::Index step, Eigen::Index count);

/// Means over `half_width` steps to either side and the value itself.
[[nodiscard]] Eigen::VectorXd running_mean(const Eigen::VectorXd& values, Eigen::Index half_width);

/// The value that a share of them, 0 ... 1, is not above. There is one at least.
[[nodiscard]] double percentile(const Eigen::VectorXd& values, double share);

/// Steps from `from` in a direction (1 or -1) until the values have fallen to below a level, with
/// the part of the last step by a straight line; none where they never do. The value at `from` is
/// not below it.
[[nodiscard]] std::optional<double> steps_until_below(const Eigen::VectorXd& values, double level,
                                                      Eigen::Index from, int direction);

}  // namespace millwear::wear
