#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "liggghts_inputs/decks/stretch.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// The share of a piece of work that a stretch makes, 0 ... 1.
struct ShareOfWork {
  double before = 0.0;
  double after = 1.0;
};

/// Follows the lines that LIGGGHTS and the recorder print, for the progress of work called `name`.
[[nodiscard]] std::function<void(std::string_view)> step_follower(
    const std::string& name, const liggghts::StretchSteps& steps, Progress& progress,
    ShareOfWork share = {});

}  // namespace millwear::orchestrator
