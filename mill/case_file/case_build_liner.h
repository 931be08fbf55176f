#pragma once
#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// The liner as new: parametric, from a CSV beside the case file, or from listed nodes.
[[nodiscard]] LinerProfile build_liner(const CaseDocument& document, const LinerSector& sector,
                                       CaseProblems& problems);

}  // namespace millwear
