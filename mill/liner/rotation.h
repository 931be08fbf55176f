#pragma once
#include <optional>
#include <span>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// Which way the mill turns: as when its liner was new, or the other way.
enum class Rotation { as_new, reversed };

/// How often the mill was reversed by a time of milling [s], given the times of its reversals,
/// increasing. One less than a second ahead counts, so that the sum of the steps that led to it
/// need not meet it to the last bit.
[[nodiscard]] int reversals_by(std::span<const double> reversal_times, double time);

/// Which way the mill turns after a time of milling [s]: as new after an even number of reversals.
[[nodiscard]] Rotation rotation_after(std::span<const double> reversal_times, double time);

/// Milling left until the next reversal [s], at least a second; std::nullopt if none comes.
[[nodiscard]] std::optional<double> time_to_reversal(std::span<const double> reversal_times,
                                                     double time);

/// The liner in a mill that always turns along the direction of xi, as the DEM's does: itself, or
/// its mirror image where the mill turns the other way. Its own inverse.
[[nodiscard]] LinerProfile as_turned(const LinerProfile& liner, Rotation rotation);

}  // namespace millwear
