#pragma once
#include <string_view>
#include <vector>

namespace millwear::liggghts {

/// What LIGGGHTS prints at the end of one `run` of a deck.
struct RunSummary {
  double loop_seconds;  ///< wall time of the steps alone, without reading and setting up [s]
  long steps;
  long neighbour_builds;  ///< neighbour lists built anew on the way
  /// Builds that a particle or the mesh may have asked for before one was allowed, so that
  /// contacts may have been missed.
  long dangerous_builds;
};

/// The summaries in a log, in their order. One that was torn off is left out.
[[nodiscard]] std::vector<RunSummary> read_run_summaries(std::string_view log);

}  // namespace millwear::liggghts
