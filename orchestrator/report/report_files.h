#pragma once
#include <filesystem>

#include "orchestrator/results/report_data.h"

namespace millwear::orchestrator {

/// Writes the report's page.
void publish_report(const std::filesystem::path& page, const ReportData& data);

/// Writes profiles.png and history.png into a folder. Throws ExternalProgramError without gnuplot.
void publish_pictures(const std::filesystem::path& folder, const ReportData& data);

}  // namespace millwear::orchestrator
