#include "orchestrator/results/measured_charge.h"

namespace millwear::orchestrator {

std::vector<MeasuredCharge> measured_charges(const std::vector<HistoryRow>& history) {
  std::vector<MeasuredCharge> charges;
  double hours_before = 0.0;
  for (const auto& row : history) {
    if (charges.empty() || charges.back().cycle != row.cycle)
      charges.push_back({.cycle = row.cycle,
                         .operating_hours = row.step == 0 ? row.operating_hours : hours_before,
                         .power = row.power,
                         .power_error = row.power_error,
                         .shoulder = row.shoulder,
                         .shoulder_error = row.shoulder_error,
                         .toe = row.toe,
                         .toe_error = row.toe_error});
    hours_before = row.operating_hours;
  }
  return charges;
}

}  // namespace millwear::orchestrator
