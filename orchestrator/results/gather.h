#pragma once
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Everything the published cycles tell, ready for the result files and the report.
/// A cycle counts from the moment its wear stage is published.
[[nodiscard]] CampaignResults gather(const Campaign& campaign, const Ledger& ledger);

}  // namespace millwear::orchestrator
