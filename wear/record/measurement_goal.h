#pragma once

namespace millwear::wear {

/// How well a measurement is to know the smoothed rate of loss at its peaks, and how well it does:
/// relative standard errors, see `peak_error`.
struct MeasurementGoal {
  double target_error;  ///< > 0
  double peak_error;    ///< NaN where it is not known
};

/// Whether the peaks are known well enough. An error that is not known is not.
[[nodiscard]] bool is_reached(const MeasurementGoal& goal);

/// How long a measurement of `length` (any unit) has to be in all for its target, if the error goes
/// on falling as 1 / sqrt(length); infinite where it is not known.
[[nodiscard]] double length_to_reach(const MeasurementGoal& goal, double length);

}  // namespace millwear::wear
