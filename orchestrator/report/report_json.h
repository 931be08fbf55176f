#pragma once
#include <string>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The data as JSON, in SI units and radians, NaN as null. Its text can stand inside a `<script>`
/// element whatever the names hold: `<` is written as an escape.
[[nodiscard]] std::string report_json(const CampaignResults& data);

}  // namespace millwear::orchestrator
