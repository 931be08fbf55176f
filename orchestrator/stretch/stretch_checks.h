#pragma once
#include <filesystem>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/case/case.h"

namespace millwear::orchestrator {

/// Throws DiskError where the disk of a folder has no room for what a stretch leaves.
void check_free_disk(const Case& mill, const liggghts::StretchSteps& steps,
                     const std::filesystem::path& into);

/// Throws ResultRejected unless log and restart file of a stretch, in `folder`, show that it came
/// to its end with all particles and a mesh of so many triangles.
void check_stretch(const Case& mill, const liggghts::StretchSteps& steps, std::size_t triangles,
                   const std::filesystem::path& folder);

/// Throws ResultRejected where the recorder has left no load (or no events, where the case keeps
/// them) in `folder`.
void check_recorded(const Case& mill, const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
