#pragma once
#include <filesystem>

#include "orchestrator/results/report_data.h"

namespace millwear::orchestrator {

/// Publishes two pictures in `folder`, drawn by gnuplot: `profiles.png` (every profile, equal
/// scales) and `history.png` (lifter height and power against hours). A picture without data is
/// left out. Throws ExternalProgramError or DiskError.
void write_plots(const ReportData& data, const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
