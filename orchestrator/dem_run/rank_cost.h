#pragma once
#include "mill/case/case.h"

namespace millwear::orchestrator {

/// How a number of ranks is likely to share the DEM of a case, in the mean over a campaign. A model
/// of three measured numbers (docs/cluster.md#know-the-cost-before); times are within a factor of
/// three from mill to mill, and better from one number of ranks to another.
struct RankCost {
  int ranks;
  int columns;       ///< across the mill
  int slabs;         ///< along the axis
  double particles;  ///< of a rank, in the mean
  double ghosts;     ///< for each of them: particles of other ranks and periodic images
  double imbalance;  ///< particles of the rank that has most, over the mean
  double step_seconds;
  double memory;  ///< of all ranks [bytes]
};

/// A slab as thick as the reach of a contact, d the largest diameter, lies on either side of
/// every cut and of the periodic ends:
///     ghosts = (1 + 2 (columns - 1) d / W) (1 + 2 d slabs / L) - 1,
/// W the width of the charge and L the slice. A step takes
///     imbalance particles (t + ghosts t_g) + (ranks > 1) t_m.
[[nodiscard]] RankCost rank_cost(const Case& mill, int ranks);

}  // namespace millwear::orchestrator
