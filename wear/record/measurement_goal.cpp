#include "wear/record/measurement_goal.h"

#include <cmath>
#include <limits>

namespace millwear::wear {

bool is_reached(const MeasurementGoal& goal) { return goal.peak_error <= goal.target_error; }

double length_to_reach(const MeasurementGoal& goal, double length) {
  const double ratio = goal.peak_error / goal.target_error;
  return std::isfinite(ratio) ? length * ratio * ratio : std::numeric_limits<double>::infinity();
}

}  // namespace millwear::wear
