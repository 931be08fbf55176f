#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear {

/// What is possible but looks wrong: speed above critical, narrow slice, counts that contradict the
/// declared fillings, wide bins. Each is "what (why, with numbers); what would be right".
[[nodiscard]] std::vector<std::string> warnings(const Case& mill);

/// Filling that the counts make by the mill owner's reckoning: bulk volume over the volume inside
/// the plate's circle, pi R^2 L, lifters not deducted.
[[nodiscard]] double filling_inside_plate(const Case& mill);

}  // namespace millwear
