#pragma once
#include <optional>

#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"
#include "mill/liner/drawn_liner.h"

namespace millwear {

/// The liner as new: parametric, from a table or a drawing beside the case file, or from listed
/// nodes.
[[nodiscard]] LinerProfile build_liner(const CaseDocument& document, const LinerSector& sector,
                                       const ReadDrawnLiner& draw, CaseProblems& problems);

/// The drawing that [lifter] names; none where the liner is given otherwise.
[[nodiscard]] std::optional<DrawnLiner> drawn_liner_in(const CaseDocument& document);

}  // namespace millwear
