#pragma once
#include <string>

#include "mill/case/case.h"

namespace millwear {

/// The case as a case file with every default filled in: the liner as `nodes_m`, the charge as
/// counts with the declared fillings; without [gauge], on which nothing simulated depends.
/// `case_from_text` of it gives the same simulation to the bit.
[[nodiscard]] std::string locked_case_text(const Case& mill);

}  // namespace millwear
