#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/results/campaign_results.h"
#include "orchestrator/results/spectra.h"
#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// A name for every particle class, its material and diameter, e.g. `steel_30mm`: no two alike, and
/// none with a comma, quote or line break.
[[nodiscard]] std::vector<std::string> class_names(const Case& mill);

/// The rows of one cycle, where anything was counted: its collisions with the liner, and those
/// between particles where they were recorded. Rates are per second of the simulated slice.
[[nodiscard]] std::vector<SpectrumRow> spectrum_rows(int cycle, const wear::LinerRecord& record,
                                                     const std::vector<std::string>& names);

/// The same for the report: with the liner by particle class, between particles by pair of
/// materials.
[[nodiscard]] Impacts impacts_of(int cycle, const wear::LinerRecord& record, const Case& mill);

}  // namespace millwear::orchestrator
