#include "orchestrator/stages/mesh_stage.h"

#include "orchestrator/campaign/mesh_files.h"

namespace millwear::orchestrator {

void mesh_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into) {
  write_mesh(campaign.mill, dem_liner_of_cycle(campaign, cycle), into);
}

}  // namespace millwear::orchestrator
