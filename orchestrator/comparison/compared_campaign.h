#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// A campaign as a page of several shows it: as it was published, also while it runs. Its folder is
/// neither locked nor written to.
struct ComparedCampaign {
  std::string name;
  Campaign campaign;
  /// History, life and mill; liners, loads and charge of some cycles spread over the campaign, the
  /// first and the last among them. The rest is empty.
  CampaignResults data;
  std::vector<std::string> missing;  ///< what is not here, a sentence each
};

/// The campaigns in these folders, in their order. Each takes its folder's name, or the folder as
/// it is given where two have the same. Throws InputError where a folder holds no campaign,
/// ResultRejected where a file is damaged or was changed since it was published.
[[nodiscard]] std::vector<ComparedCampaign> compared_campaigns(
    const std::vector<std::filesystem::path>& folders);

}  // namespace millwear::orchestrator
