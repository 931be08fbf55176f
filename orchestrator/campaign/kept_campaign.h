#pragma once
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

/// A finished or unfinished campaign as its folder keeps it.
struct KeptCampaign {
  Campaign campaign;  ///< its case as it was run
  Ledger ledger;
};

/// Reads the campaign in a folder and checks the loads and steps that it keeps. Throws Failure
/// (usage) where there is no campaign or no load yet, ResultRejected where a load or the steps of a
/// cycle are not as they were published.
[[nodiscard]] KeptCampaign kept_campaign(const RunFolder& folder);

}  // namespace millwear::orchestrator
