#include "orchestrator/stretch/stretch_progress.h"

#include <algorithm>

#include "liggghts_inputs/outputs/run_log.h"
#include "mill/recording/recorder_lines.h"

namespace millwear::orchestrator {

StretchProgress::StretchProgress(const liggghts::StretchSteps& planned)
    : expected_end_(static_cast<double>(planned.total())) {
  if (planned.go_on_steps > 0)
    expected_end_ += 0.5 * static_cast<double>(planned.most_measure_steps - planned.measure_steps);
}

bool StretchProgress::take(std::string_view line) {
  if (const auto told = measuring_line(line); told && told->next) {
    from_step_ = static_cast<double>(told->step);
    from_done_ = done_;
    expected_end_ = static_cast<double>(told->next->expected_step);
    return true;
  }
  liggghts::ThermoLine thermo{};
  if (!liggghts::read_thermo_line(line, thermo)) return false;
  const double gone = static_cast<double>(thermo.step) - from_step_;
  const double share = gone / std::max(expected_end_ - from_step_, 1.0);
  done_ = std::clamp(from_done_ + (1.0 - from_done_) * share, done_, std::max(done_, 1.0));
  return true;
}

}  // namespace millwear::orchestrator
