#pragma once
#include <filesystem>
#include <vector>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The life as `summary.json` in the folder `tables` has it. Without that file it is the hours of
/// the history so far, with the limit of `before`. Throws ResultRejected where the file cannot be
/// understood.
[[nodiscard]] Life published_life(const std::filesystem::path& tables,
                                  const std::vector<HistoryRow>& history, const Life& before);

}  // namespace millwear::orchestrator
