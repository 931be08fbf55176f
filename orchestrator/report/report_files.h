#pragma once
#include <filesystem>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Writes the report's page.
void publish_report(const std::filesystem::path& page, const CampaignResults& data);

/// Writes profiles.png and history.png into a folder. Throws ExternalProgramError without gnuplot.
void publish_pictures(const std::filesystem::path& folder, const CampaignResults& data);

}  // namespace millwear::orchestrator
