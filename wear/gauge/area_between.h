#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// Section between two profiles of one pitch, wherever one stands above the other [m2]: that of
/// the steel that only one of them has. Within 1e-9 m times their lengths; exactly 0 for the same
/// profile. Throws ResultRejected where it cannot be found.
[[nodiscard]] double area_between(const LinerProfile& a, const LinerProfile& b);

}  // namespace millwear::wear
