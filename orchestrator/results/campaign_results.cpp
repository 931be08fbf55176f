#include "orchestrator/results/campaign_results.h"

#include <fmt/format.h>

#include <cmath>

namespace millwear::orchestrator {

CampaignResults results_of_case(const Case& mill) {
  CampaignResults data{};
  data.case_name = mill.name;
  data.life = {false, 0.0, std::nan(""), std::nan(""), std::nan(""), spoken_height_limit(mill)};
  data.sector = mill.liner.sector;
  data.height_limit = mill.campaign.height_limit;
  data.plate_limit = mill.campaign.plate_limit;
  data.liner_density = mill.materials[mill.liner_material].density;
  return data;
}

std::string spoken_height_limit(const Case& mill) {
  return fmt::format("lifter height {:g} mm", 1e3 * mill.campaign.height_limit);
}

}  // namespace millwear::orchestrator
