#pragma once
#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// The wear law, of [wear] itself or of [[wear.mechanisms]], and its bins and blocks.
[[nodiscard]] WearSettings build_wear(const CaseDocument& document,
                                      const std::vector<Material>& materials,
                                      CaseProblems& problems);

}  // namespace millwear
