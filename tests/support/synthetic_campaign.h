#pragma once
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// A made-up campaign on a mill of 8 m with 52 lifters of 215 mm: `cycles` DEM loads of
/// `steps` geometry steps each, the shapes from a formula and the noise from a fixed seed.
[[nodiscard]] CampaignResults synthetic_campaign(int cycles, int steps);

}  // namespace millwear::orchestrator
