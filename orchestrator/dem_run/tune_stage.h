#pragma once
#include <filesystem>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/stage.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// Times neighbour skins and splits among ranks on the mixed charge, and keeps the fastest.
void tune_stage(const Campaign& campaign, const std::filesystem::path& into, Progress& progress);

/// The case that a stretch's decks are written for: with the settings that the campaign's tune
/// stage chose, where it has one and the stretch is after it. Throws what `read_tuning` throws.
[[nodiscard]] Case case_of_stretch(const Campaign& campaign, const StageId& stage);

}  // namespace millwear::orchestrator
