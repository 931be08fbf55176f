#pragma once
#include <string>

#include "orchestrator/calibration/repeated_courses.h"

namespace millwear::orchestrator {

/// The table for a reader.
[[nodiscard]] std::string repeated_text(const RepeatedCourses& repeats);

/// The same as JSON, in SI units, hours aside; null where nothing is known.
[[nodiscard]] std::string repeated_json(const RepeatedCourses& repeats);

/// The bytes of a table `# millwear repeated comparison 1` (docs/file_formats.md).
[[nodiscard]] std::string repeated_csv(const RepeatedCourses& repeats);

}  // namespace millwear::orchestrator
