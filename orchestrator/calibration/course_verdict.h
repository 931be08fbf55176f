#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// Prediction against straight line over the held-out readings: which is better and by how much,
/// and the percentages of both.
[[nodiscard]] std::string verdict_of(const CalibratedCourse& course);

/// Mean absolute percentage errors [-] of a prediction and of the straight line, beside the one
/// that straight lines had over readings of many plants (Minerals 14, 2024, 1200).
[[nodiscard]] std::string percentages_of(double prediction, double line);

/// What to keep in mind with the figures of a calibrated course.
[[nodiscard]] std::vector<std::string> remarks_of(const CalibratedCourse& course, const Case& mill,
                                                  bool has_replicates);

/// "from the new plate" or "from the worn plate"
[[nodiscard]] std::string spoken(GaugeOn gauge);

}  // namespace millwear::orchestrator
