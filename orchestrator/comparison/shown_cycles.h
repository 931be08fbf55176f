#pragma once
#include <cstddef>
#include <vector>

#include "orchestrator/results/history.h"

namespace millwear::orchestrator {

/// The cycles of a history, each once.
[[nodiscard]] std::vector<int> cycles_of(const std::vector<HistoryRow>& history);

/// At most `most` (two or more) of the cycles, evenly spread, the first and the last among them.
[[nodiscard]] std::vector<int> spread(const std::vector<int>& cycles, std::size_t most);

}  // namespace millwear::orchestrator
