#include "orchestrator/dem_run/stretch_progress.h"

#include <algorithm>
#include <charconv>

#include "liggghts_inputs/outputs/run_log.h"

namespace millwear::orchestrator {
namespace {

constexpr std::string_view from_recorder = "millwear: step ";
constexpr std::string_view expected = "perhaps to ";

/// The whole number behind `words` in a line, or 0.
double number_after(std::string_view line, std::string_view words) {
  const auto place = line.find(words);
  if (place == std::string_view::npos) return 0.0;
  long number = 0;
  std::from_chars(line.data() + place + words.size(), line.data() + line.size(), number);
  return static_cast<double>(number);
}

}  // namespace

StretchProgress::StretchProgress(const liggghts::StretchSteps& planned)
    : expected_end_(static_cast<double>(planned.total())) {
  if (planned.go_on_steps > 0)
    expected_end_ += 0.5 * static_cast<double>(planned.most_measure_steps - planned.measure_steps);
}

bool StretchProgress::take(std::string_view line) {
  if (line.starts_with(from_recorder) && line.find(expected) != std::string_view::npos) {
    from_step_ = number_after(line, from_recorder);
    from_done_ = done_;
    expected_end_ = number_after(line, expected);
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
