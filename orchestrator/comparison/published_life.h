#pragma once
#include <filesystem>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Of a campaign that has no cycle yet: 0 h, and the limit that the case names first.
[[nodiscard]] Life life_without_cycles(const Case& mill);

/// The life as `summary.json` in the folder `tables` has it. Without that file it is the hours of
/// the history so far, with the limit of `before`. Throws ResultRejected where the file cannot be
/// understood.
[[nodiscard]] Life published_life(const std::filesystem::path& tables,
                                  const std::vector<HistoryRow>& history, const Life& before);

}  // namespace millwear::orchestrator
