#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear {

/// What is possible but looks wrong: speed above critical, narrow slice, counts that contradict the
/// declared fillings, wide bins. Each is "what (why, with numbers); what would be right".
[[nodiscard]] std::vector<std::string> warnings(const Case& mill);

}  // namespace millwear
