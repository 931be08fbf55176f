#pragma once
#include <string>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The charge of every cycle as the page's JSON: maps over the section and polar maps in eight
/// bits, with the same scale for all cycles, landmarks, and frames of the first, the middle and the
/// last cycle.
[[nodiscard]] std::string charge_json(const CampaignResults& data);

}  // namespace millwear::orchestrator
