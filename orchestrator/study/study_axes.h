#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear::orchestrator {

/// One thing that a study varies.
struct StudyAxis {
  std::string key;  ///< of the case, by its dotted name, or a derived one (study/derived_axes.h)
  int line;         ///< of the study file
  std::vector<CaseValue> values;    ///< none where the axis is an interval
  std::vector<std::string> labels;  ///< of the values, as tables and folders show them
  double low = 0.0;                 ///< of an interval, for `latin_hypercube`
  double high = 0.0;
};

/// How a study file gives an axis.
enum class AxisForm {
  values,    ///< listed
  interval,  ///< from `low` to `high`
};

/// The axis of an `[[axes]]` table. What is wrong with it becomes a problem.
[[nodiscard]] StudyAxis axis_in(const CaseTable& table, AxisForm form, CaseProblems& problems);

/// The axes of a table of points: its header names keys, its rows are points.
[[nodiscard]] std::vector<StudyAxis> axes_of_table(const std::filesystem::path& file,
                                                   CaseProblems& problems);

/// The axis of `KEY=VALUE,VALUE` or `KEY=LOW:HIGH:STEP`. Throws InputError.
[[nodiscard]] StudyAxis axis_from_words(const std::string& words);

}  // namespace millwear::orchestrator
