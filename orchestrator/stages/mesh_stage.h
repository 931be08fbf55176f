#pragma once
#include <filesystem>

#include "orchestrator/campaign/campaign.h"

namespace millwear::orchestrator {

/// Writes the mesh of the liner that a cycle's DEM turns, and its section for CAD, into `into`.
void mesh_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into);

}  // namespace millwear::orchestrator
