#pragma once
#include "orchestrator/results/report_data.h"
#include "orchestrator/stages/stages.h"

namespace millwear::orchestrator {

/// Writes results/history.csv, profiles.csv, replicates.csv, bins.h5 and summary.json, each whole.
void publish_results(const Campaign& campaign, const Ledger& ledger, const ReportData& data);

/// Writes report.html.
void publish_report(const Campaign& campaign, const ReportData& data);

/// Writes results/profiles.png and history.png. Throws ExternalProgramError without gnuplot.
void publish_pictures(const Campaign& campaign, const ReportData& data);

}  // namespace millwear::orchestrator
