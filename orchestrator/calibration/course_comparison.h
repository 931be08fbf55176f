#pragma once
#include <string>

#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// The table of a calibrated course for a reader.
[[nodiscard]] std::string course_text(const CalibratedCourse& course);

/// The same as JSON, in SI units, hours aside; null where nothing is known.
[[nodiscard]] std::string course_json(const CalibratedCourse& course);

/// The bytes of a table `# millwear calibrated comparison 1` (docs/file_formats.md).
[[nodiscard]] std::string course_csv(const CalibratedCourse& course);

}  // namespace millwear::orchestrator
