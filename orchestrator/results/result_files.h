#pragma once
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Writes results/history.csv, profiles.csv, replicates.csv, bins.h5, landmarks.csv, spectra.csv
/// and summary.json, each whole.
void publish_results(const Campaign& campaign, const Ledger& ledger, const CampaignResults& data);

}  // namespace millwear::orchestrator
