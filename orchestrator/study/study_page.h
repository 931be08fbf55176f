#pragma once
#include <string>

#include "orchestrator/report/script_library.h"
#include "orchestrator/study/study_results.h"

namespace millwear::orchestrator {

/// The study as one page that opens without a network: best point, table, effects, trade-offs,
/// courses and profiles. Reads the histories and profiles of the campaigns that are done.
[[nodiscard]] std::string study_html(const StudyResults& results, const ScriptLibrary& d3);

}  // namespace millwear::orchestrator
