#pragma once
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Path over slip above which the time step is too long for jammed particles. Where the whole
/// liner's was 1.2 its load was that of half the time step, where it was 2.1 it was 7 +- 5 % more,
/// where it was 2.7 a quarter (docs/physics.md, "Particles that shake").
inline constexpr double longest_path_over_slip = 1.5;

/// Scatter of successive loads, over what their time blocks say, above which something else than
/// noise is at work. On mills that are mixed long enough it is 1.0 to 1.6.
inline constexpr double largest_load_scatter = 3.0;

/// What to keep in mind of the cycle in which particles shook most; nothing where they did not, or
/// where it is not known.
[[nodiscard]] std::optional<std::string> shaking_warning(const std::vector<Conservation>& cycles);

/// Likewise of the cycle about which loads jump most.
[[nodiscard]] std::optional<std::string> jumping_warning(const std::vector<Conservation>& cycles);

}  // namespace millwear::orchestrator
