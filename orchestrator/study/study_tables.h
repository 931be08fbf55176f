#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "orchestrator/study/study_results.h"

namespace millwear::orchestrator {

/// The table `study.csv`, a row a point (docs/file_formats.md).
[[nodiscard]] std::string study_csv(const StudyResults& results);

/// The same as JSON, with the campaigns of every point.
[[nodiscard]] std::string study_json(const StudyResults& results);

/// The same before it is a text, for the page.
[[nodiscard]] nlohmann::ordered_json study_document(const StudyResults& results);

/// The table for a reader: axes, state, life, height, power, objective.
[[nodiscard]] std::string study_text(const StudyResults& results);

}  // namespace millwear::orchestrator
