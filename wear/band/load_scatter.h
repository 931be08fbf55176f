#pragma once
#include <span>

#include "wear/evolve/timed_load.h"

namespace millwear::wear {

/// By how much loads that follow each other scatter more than the time blocks of each say [-], >=
/// 1: the Birge ratio of three successive loads each, by zones of the liner of the middle one
/// (`zoned`),
///     sqrt(mean of (y_i - line between y_(i-1) and y_(i+1))^2 / its variance).
/// What lies still for a whole measurement is the same in all its blocks, and shows only from one
/// load to the next. A load that changes along a curve counts as scatter, which errs to the safe
/// side. 1 for fewer than three loads, or without blocks; `loads` in the order of their times.
/// Source: Birge (1932), Physical Review 40, 207.
[[nodiscard]] double birge_ratio(std::span<const TimedLoad* const> loads);

}  // namespace millwear::wear
