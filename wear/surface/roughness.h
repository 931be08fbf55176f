#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// How rough a liner is to balls of `radius` [m] and larger: the section between the liner and its
/// closing by a disc of that radius, per length of the liner [m]. Balls cannot wear a hollow into
/// steel that they cannot touch, so beyond the feet of a new lifter it is not of their making. An
/// edge that stands out adds nothing.
[[nodiscard]] double roughness(const LinerProfile& profile, double radius);

}  // namespace millwear::wear
