#pragma once
#include <filesystem>
#include <vector>

#include "liggghts_inputs/decks/chunks.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// Simulates the mixing of a cycle in chunks that are not done yet, and leaves in `into` what a
/// mixing in one piece leaves, with the decks and the log of every chunk.
void mix_in_chunks(const Campaign& campaign, int cycle, const std::vector<liggghts::Chunk>& chunks,
                   const std::filesystem::path& into, Progress& progress);

/// The same of a measurement. One that goes on until its load is known does so by further chunks.
void record_in_chunks(const Campaign& campaign, int cycle, const liggghts::StretchSteps& stretch,
                      const std::vector<liggghts::Chunk>& chunks, const std::filesystem::path& into,
                      Progress& progress);

}  // namespace millwear::orchestrator
