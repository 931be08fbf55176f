#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// A key in which not all cases are the same, and its value in each; "none" where a case has not
/// got it, "14 points" for an outline.
struct DifferingKey {
  std::string key;  ///< "[dem] `seed`"
  std::vector<std::string> values;
};

/// All of them, defaults filled in, in the order of the locked case.
[[nodiscard]] std::vector<DifferingKey> differing_keys(const std::vector<Case>& cases);

}  // namespace millwear::orchestrator
