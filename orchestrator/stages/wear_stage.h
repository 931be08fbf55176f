#pragma once
#include <filesystem>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// Takes the geometry steps of a cycle on its load and writes them into `into`; returns how they
/// leave the liner.
[[nodiscard]] Outcome wear_stage(const Campaign& campaign, int cycle,
                                 const std::filesystem::path& into);

}  // namespace millwear::orchestrator
