#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// The changes of operation of a mill that is complete otherwise, from [[campaign.operation]] or
/// the table of `operation_csv`. Shares of the critical speed become speeds, and fillings particle
/// counts. Adds to `problems` what is wrong: periods missing or given twice, times that run
/// backwards, a height that is never met, a charge that does not fit, a change of nothing.
[[nodiscard]] std::vector<OperatingChange> build_operation(const CaseDocument& document,
                                                           const Case& mill,
                                                           CaseProblems& problems);

}  // namespace millwear
