#include "orchestrator/comparison/shown_cycles.h"

namespace millwear::orchestrator {

std::vector<int> cycles_of(const std::vector<HistoryRow>& history) {
  std::vector<int> cycles;
  for (const auto& row : history)
    if (cycles.empty() || cycles.back() != row.cycle) cycles.push_back(row.cycle);
  return cycles;
}

std::vector<int> spread(const std::vector<int>& cycles, std::size_t most) {
  if (cycles.size() <= most) return cycles;
  std::vector<int> chosen;
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(cycles[(i * (cycles.size() - 1) + (most - 1) / 2) / (most - 1)]);
  return chosen;
}

}  // namespace millwear::orchestrator
