#pragma once
#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// Particle classes from counts, or from fillings and distributions in a slice of `slice_length`
/// [m]; largest first.
[[nodiscard]] Charge build_charge(const CaseDocument& document,
                                  const std::vector<Material>& materials, const LinerSector& sector,
                                  double slice_length, CaseProblems& problems);

}  // namespace millwear
