#pragma once
#include <string>

#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// A picture (PNG) of a calibrated course: the predicted heights with their 95 % band, the straight
/// line, and the readings with their errors. Throws ExternalProgramError without gnuplot.
[[nodiscard]] std::string course_png(const CalibratedCourse& course);

}  // namespace millwear::orchestrator
