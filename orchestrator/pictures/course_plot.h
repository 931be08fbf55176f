#pragma once
#include <string>
#include <vector>

#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// A picture (PNG) of calibrated courses on the same readings: the predicted heights, of a single
/// course with their 95 % band, the straight line, and the readings with their errors. At least one
/// course (std::logic_error). Throws ExternalProgramError without gnuplot.
[[nodiscard]] std::string course_png(const std::vector<CalibratedCourse>& courses);

}  // namespace millwear::orchestrator
