#pragma once
#include <string>

namespace millwear::orchestrator {

/// gnuplot's commands for a PNG of this size [px] in the report's colours.
[[nodiscard]] std::string plot_terminal(int width, int height);

}  // namespace millwear::orchestrator
