#pragma once
#include <utility>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// Indices of the first pair of segments that cross (over the pitch and its two neighbours), or
/// {-1, -1} where the profile is simple.
[[nodiscard]] std::pair<int, int> first_crossing(const LinerProfile& profile);

}  // namespace millwear
