#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/case_document.h"
#include "orchestrator/study/study_file.h"

namespace millwear::orchestrator {

/// The values of all axes for one point of a study, in the order of the axes.
struct PointValues {
  std::vector<CaseValue> values;
  std::vector<std::string> labels;
};

/// A campaign of a study: a point, and which of its replicates.
struct StudyCampaign {
  std::size_t point;      ///< index into the points
  std::uint64_t seed;     ///< of the packing
  std::string case_text;  ///< the case with every default filled in, as it is run
  std::string hash;       ///< of that text and of how this program makes results of it
  std::size_t particles;
  double time_step;   ///< of the DEM [s]
  double cost;        ///< DEM of the whole campaign, a guess [s on one core]
  double chunk_cost;  ///< of its longest chunk, likewise
};

/// A study with the cases of all its campaigns.
struct StudyPlan {
  Study study;
  Case base;
  std::vector<PointValues> points;
  std::vector<StudyCampaign> campaigns;  ///< point by point, replicate by replicate
};

/// Whether an axis takes whole numbers only.
[[nodiscard]] bool is_whole_axis(const std::string& key);

/// How many points a study has; of a table its rows, of a Latin
/// hypercube and a search as many as it may have.
[[nodiscard]] std::size_t point_count(const Study& study);

/// The values of all points. A Latin hypercube divides every axis in as many even parts as there
/// are points, and each part has one point, at random within it; the same seed gives the same
/// points. Source: McKay, Beckman and Conover (1979), Technometrics 21, 239.
[[nodiscard]] std::vector<PointValues> point_values(const Study& study);

/// The base case with the values of a point. Derived axes come last; with an axis `mill.rows`,
/// `spacing_to_height` chooses the height. Throws InputError ("file:line: ...") where the case
/// refuses a value.
[[nodiscard]] CaseDocument document_of_point(const Study& study, const CaseDocument& base,
                                             const PointValues& point);

/// Reads the base case and makes all campaigns. Throws InputError as `document_of_point`.
[[nodiscard]] StudyPlan plan_of(const Study& study);

}  // namespace millwear::orchestrator
