#pragma once
#include <Eigen/Core>
#include <span>

namespace millwear::wear {

/// A length of the liner over time: linear between its moments, unknown before and after them.
struct Course {
  Eigen::VectorXd times;   ///< increasing, the first 0; any unit
  Eigen::VectorXd values;  ///< [m]
};

/// NaN before the first moment and after the last.
[[nodiscard]] double value_at(const Course& course, double time);

/// When the course first stands at `value` or below; NaN where it never does.
[[nodiscard]] double time_of(const Course& course, double value);

/// A length that was read.
struct DatedLength {
  double time;   ///< above 0
  double value;  ///< [m]
  double error;  ///< standard error [m], above 0
};

/// Where the best factor lies.
enum class FactorPlace {
  inside,
  not_worn,  ///< at 0: the readings show no wear
  beyond     ///< the readings ask for more wear than the course has
};

/// The factor on the coefficients that fits a course to its readings.
struct CourseFactor {
  double factor;
  FactorPlace place;
};

/// The factor f on the coefficients of a wear law that lays the course H on the readings. All
/// rates being linear in the coefficients, a liner worn with all of them times f passes the same
/// shapes in times divided by f:
///     min over f of  sum (H(f t_i) - h_i)^2 / e_i^2,    0 <= f <= (last moment) / max t_i.
/// Exact for the piecewise linear course; the least factor where several are as good. With one
/// reading H(f t) = h. `readings` is not empty.
[[nodiscard]] CourseFactor factor_of(const Course& course, std::span<const DatedLength> readings);

/// Rate of the straight line h = `fresh` - rate t by the same least squares: the line starts at
/// the new liner, as every prediction does.
[[nodiscard]] double straight_rate(double fresh, std::span<const DatedLength> readings);

}  // namespace millwear::wear
