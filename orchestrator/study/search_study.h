#pragma once
#include <filesystem>
#include <vector>

#include "orchestrator/study/design_search.h"
#include "orchestrator/study/study_folder.h"
#include "orchestrator/study/study_results.h"

namespace millwear::orchestrator {

/// The study of the points that a search has tried: the search with its places as values of the
/// axes.
[[nodiscard]] Study with_places(const Study& search,
                                const std::vector<std::vector<double>>& places);

/// The axes of a search as intervals.
[[nodiscard]] std::vector<SearchInterval> intervals_of(const Study& search);

/// What the points of a search are worth to it: the objective, turned so that more is better. A
/// point that keeps a limit badly is worth less than the worst that keeps all, the less the further
/// it is off. Points without a result are left out.
[[nodiscard]] std::vector<SearchValue> values_of(const StudyResults& results,
                                                 const std::vector<std::vector<double>>& places);

/// The places that a search has tried, in their order; none without the file. Throws DiskError and
/// ResultRejected.
[[nodiscard]] std::vector<std::vector<double>> read_places(const std::filesystem::path& file,
                                                           const Study& search);
void write_places(const std::filesystem::path& file, const Study& search,
                  const std::vector<std::vector<double>>& places);

/// The plan of a study as far as its points are known: those that a search has tried stand in its
/// folder.
[[nodiscard]] StudyPlan plan_so_far(const StudyFolder& folder, const Study& study);

}  // namespace millwear::orchestrator
