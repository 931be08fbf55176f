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

/// The decks of a stretch and, for a mixing one, its charge, written into `into`. What there is to
/// say of the charge is returned, nothing of a packing.
std::string write_mixing_deck(const Campaign& campaign, int cycle,
                              const std::filesystem::path& into);
void write_measuring_deck(const Campaign& campaign, int cycle, const std::filesystem::path& into);

/// What millwear-recorder is told of a measuring stretch; paths are from the stage's folder.
[[nodiscard]] std::vector<std::string> recorder_arguments(const Case& mill);

}  // namespace millwear::orchestrator
