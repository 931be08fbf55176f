#pragma once
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/campaign/open_campaign.h"
#include "wear/calibrate/wear_path.h"

namespace millwear::orchestrator {

/// The cycles of a campaign that have a load, with the rates of every mechanism of `other` beside
/// those of the campaign's law, smoothed alike. Throws Failure (usage) where no wear is done yet.
[[nodiscard]] std::vector<wear::PathCycle> path_cycles(const OpenCampaign& kept, const Case& other);

}  // namespace millwear::orchestrator
