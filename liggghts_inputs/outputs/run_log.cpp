#include "liggghts_inputs/outputs/run_log.h"

#include <charconv>

#include "liggghts_inputs/decks/stretch.h"

namespace millwear::liggghts {
namespace {

template <class Number>
bool take(std::string_view& text, Number& value) {
  const auto start = text.find_first_not_of(' ');
  if (start == std::string_view::npos) return false;
  text.remove_prefix(start);
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace

bool read_thermo_line(std::string_view line, ThermoLine& thermo) {
  return take(line, thermo.step) && take(line, thermo.atoms) && take(line, thermo.kinetic_energy) &&
         take(line, thermo.spin_energy) && take(line, thermo.torque) &&
         line.find_first_not_of(" \r") == std::string_view::npos;
}

RunLog read_run_log(std::string_view log) {
  RunLog run;
  while (!log.empty()) {
    const auto end = log.find('\n');
    const std::string_view line = log.substr(0, end);
    log.remove_prefix(end == std::string_view::npos ? log.size() : end + 1);
    ThermoLine thermo{};
    if (read_thermo_line(line, thermo)) {
      run.thermo.push_back(thermo);
    } else if (line.starts_with("Import and parallelization of mesh")) {
      constexpr std::string_view before = "containing ";
      auto count = line.substr(line.find(before) + before.size());
      take(count, run.triangles);
    } else if (line.starts_with("ERROR") && run.error.empty()) {
      run.error = line;
    } else if (line == sentinel) {
      run.complete = true;
    }
  }
  return run;
}

}  // namespace millwear::liggghts
