#pragma once
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/results/campaign_results.h"
#include "wear/band/campaign_band.h"
#include "wear/rate/load_rate.h"

namespace millwear::orchestrator {

/// A cycle's load with replicates of what is not known of it, and the steps that were taken on it;
/// `time` is when the load was measured, `milling_time_before` [s].
/// The same case and loads always give the same replicates.
[[nodiscard]] wear::WornCycle worn_cycle(const Campaign& campaign, int cycle, double time,
                                         const wear::LoadRate& rate, const KeptCycle& kept);

/// Fills in the standard errors of history and profiles, the replicates, and the band of a life
/// that is reached.
/// `data.history` and `data.profiles` have a row for the new liner and one for every step.
void add_uncertainty(const Case& mill, const std::vector<wear::WornCycle>& cycles,
                     CampaignResults& data);

}  // namespace millwear::orchestrator
