#pragma once
#include <string>

#include "orchestrator/pictures/scene.h"

namespace millwear::orchestrator {

/// Colour of a share of a scale, 0 ... 1 (beyond it, that of the end): dark violet over blue, green
/// to yellow, ever brighter, as gnuplot's and every reader's viridis.
[[nodiscard]] Rgb ramp_colour(double share);

/// gnuplot's command for the same ramp.
[[nodiscard]] std::string ramp_palette();

/// "#1a2b3c"
[[nodiscard]] std::string hex(const Rgb& colour);

}  // namespace millwear::orchestrator
