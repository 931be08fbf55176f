#pragma once
#include "mill/case/case.h"

namespace millwear::orchestrator {

/// Particle steps a second of one core on dense charges of a mill, measured: the pilot mill (1,200
/// balls) makes 3.1e6 on each of two cores, 38,000 particles of 45 to 180 mm in 8 m make 1.4e6.
inline constexpr double particle_steps_per_second = 1.5e6;

/// Ranks a run takes: the case's, or every core that this process may use.
[[nodiscard]] int ranks_for(const Case& mill);

/// What LIGGGHTS is likely to take [s]; within a factor of three.
struct CostEstimate {
  double mixing;          ///< the first stretch
  double per_cycle;       ///< each measurement, at least
  double per_cycle_most;  ///< the same, unless a measurement may go on
};
[[nodiscard]] CostEstimate estimate_cost(const Case& mill, int ranks);

}  // namespace millwear::orchestrator
