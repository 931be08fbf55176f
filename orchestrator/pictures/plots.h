#pragma once
#include <filesystem>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Publishes two pictures in `folder`, drawn by gnuplot: `profiles.png` (every profile, equal
/// scales) and `history.png` (lifter height and power against hours). A picture without data is
/// left out. Throws ExternalProgramError or DiskError.
void write_plots(const CampaignResults& data, const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
