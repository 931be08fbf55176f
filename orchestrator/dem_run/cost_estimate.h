#pragma once
#include "mill/case/case.h"

namespace millwear::orchestrator {

/// Ranks a run takes: the case's, or every core that this process may use.
[[nodiscard]] int ranks_for(const Case& mill);

/// What LIGGGHTS is likely to take [s]; within a factor of three.
struct CostEstimate {
  double mixing;          ///< the first stretch
  double per_cycle;       ///< each measurement, at least
  double per_cycle_most;  ///< the same, unless a measurement may go on
  double longest_chunk;   ///< what a stop may cost (liggghts_inputs/decks/chunks.h)
};
[[nodiscard]] CostEstimate estimate_cost(const Case& mill, int ranks);

/// What a whole campaign is likely to take [s]: mixing and a dozen loads, or `cycle_limit` if that
/// is less.
[[nodiscard]] double campaign_seconds(const Case& mill, const CostEstimate& cost);

}  // namespace millwear::orchestrator
