#include "liggghts_inputs/outputs/run_summary.h"

#include <charconv>

namespace millwear::liggghts {
namespace {

/// Takes the number behind `words` out of a line, and what stands before it with it.
template <class Number>
bool take_after(std::string_view& line, std::string_view words, Number& value) {
  const auto place = line.find(words);
  if (place == std::string_view::npos) return false;
  const char* const first = line.data() + place + words.size();
  const char* const last = line.data() + line.size();
  const auto [end, problem] = std::from_chars(first, last, value);
  if (problem != std::errc{}) return false;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return true;
}

}  // namespace

std::vector<RunSummary> read_run_summaries(std::string_view log) {
  std::vector<RunSummary> summaries;
  RunSummary run{};
  bool is_open = false;
  for (std::size_t end; (end = log.find('\n')) != std::string_view::npos;) {
    std::string_view line = log.substr(0, end);
    log.remove_prefix(end + 1);
    if (line.starts_with("Loop time of ")) {
      run = {};
      is_open = take_after(line, "Loop time of ", run.loop_seconds) &&
                take_after(line, " procs for ", run.steps);
      run.neighbour_builds = -1;
    } else if (is_open && line.starts_with("Neighbor list builds = ")) {
      is_open = take_after(line, "Neighbor list builds = ", run.neighbour_builds);
    } else if (is_open && run.neighbour_builds >= 0 &&
               take_after(line, "Dangerous builds = ", run.dangerous_builds)) {
      summaries.push_back(run);
      is_open = false;
    }
  }
  return summaries;
}

}  // namespace millwear::liggghts
