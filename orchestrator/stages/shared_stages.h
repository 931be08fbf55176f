#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// All that decides what the DEM of a stage (mix or dem) gives, as one hash: the case but for wear
/// law, smoothing, limits and name, and before a measurement but for how that is made, the cycle's
/// liner, the charge it begins with, ranks and program. Campaigns with the same hash simulate the
/// same, to the bit. Where a measurement goes on until a rate is known, the law counts as well.
[[nodiscard]] std::string hash_of_dem(const Campaign& campaign, const StageId& stage);

/// Fills a stage's folder from the store of a study, where another campaign has left a stage of
/// this hash, or else does the work and leaves it there. Campaigns that want the same stage at the
/// same time wait for the first. A stored file that is not as it was left does not count. Throws
/// DiskError and what the work throws; nothing is then left in the store.
void fill_shared(const std::filesystem::path& store, const std::string& hash,
                 const std::filesystem::path& into, const std::function<void()>& work);

}  // namespace millwear::orchestrator
