#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// Packs the charge of a cycle and mixes it: the work of its mix stage, into `into`.
void mix_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into,
               Progress& progress);

/// Settles the charge on a cycle's mesh and records the load: the DEM of its dem stage. What it
/// leaves does not depend on the wear law, unless a measurement goes on until a rate is known.
void simulate_load(const Campaign& campaign, int cycle, const std::filesystem::path& into,
                   Progress& progress);

/// What the recorded load says by the case's law: the rest of the dem stage.
void measure_load(const Campaign& campaign, int cycle, const std::filesystem::path& into,
                  Progress& progress);

}  // namespace millwear::orchestrator
