#pragma once
#include <vector>

#include "orchestrator/results/history.h"

namespace millwear::orchestrator {

/// What the charge did in one cycle's measurement, at the age of the liner that it ran on.
struct MeasuredCharge {
  int cycle;
  double operating_hours;  ///< of the liner when the measurement was made [h]
  double power;            ///< [W]
  double power_error;
  double shoulder;  ///< [rad]
  double shoulder_error;
  double toe;  ///< [rad]
  double toe_error;
};

/// One for each cycle of the history. A cycle whose rows begin after its first geometry step was
/// measured on the last profile of the cycle before (on the new liner for the first).
[[nodiscard]] std::vector<MeasuredCharge> measured_charges(const std::vector<HistoryRow>& history);

}  // namespace millwear::orchestrator
