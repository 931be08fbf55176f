#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "liggghts_inputs/decks/chunks.h"
#include "liggghts_inputs/decks/deck.h"
#include "orchestrator/campaign/campaign.h"

namespace millwear::orchestrator {

/// Where the chunks of a stage grow: beside its own folder, so that paths in a deck fit both.
[[nodiscard]] std::filesystem::path chunk_folder(const Campaign& campaign, const StageId& stage,
                                                 int chunk);

/// The restart file that the measurement of a cycle begins with.
[[nodiscard]] std::filesystem::path restart_before_stretch(const Campaign& campaign, int cycle);

/// The liner's mesh as a stretch of a cycle reads it.
[[nodiscard]] liggghts::LinerMeshFile mesh_of_cycle(const Campaign& campaign, int cycle);

/// The decks of a chunk and, for the first of a mixing, its charge, written into `into`. What there
/// is to say of the charge is returned, nothing of a packing.
std::string write_mixing_deck(const Campaign& campaign, int cycle, const liggghts::Chunk& chunk,
                              const std::filesystem::path& into);
void write_measuring_deck(const Campaign& campaign, int cycle, const liggghts::Chunk& chunk,
                          const std::filesystem::path& into);

/// The same of a stretch in one piece.
std::string write_mixing_deck(const Campaign& campaign, int cycle,
                              const std::filesystem::path& into);
void write_measuring_deck(const Campaign& campaign, int cycle, const std::filesystem::path& into);

/// What millwear-recorder is told of a measuring stretch in one piece, or of a chunk of it; paths
/// are from the stage's folder.
[[nodiscard]] std::vector<std::string> recorder_arguments(const Case& mill, int ranks);
[[nodiscard]] std::vector<std::string> recorder_arguments(const Case& mill, int ranks,
                                                          const liggghts::StretchSteps& stretch,
                                                          const liggghts::Chunk& chunk);

}  // namespace millwear::orchestrator
