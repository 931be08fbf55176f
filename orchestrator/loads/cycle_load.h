#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/loads/impacts.h"
#include "orchestrator/loads/load_along_profile.h"
#include "wear/evolve/timed_load.h"
#include "wear/rate/smoothing.h"
#include "wear/record/load_store.h"
#include "wear/record/polar_load.h"

namespace millwear::orchestrator {

/// All that a campaign takes from one cycle's `load.h5`, which is read once: the rest of the
/// campaign works with this.
struct CycleLoad {
  wear::SmoothedLoss smoothed;
  Eigen::MatrixXd by_block;  ///< of `wear::LoadRate`
  wear::Rolling rolling;
  double worn_by_load;     ///< rate of loss summed over the bins of the raw load [m2/s]
  int block_count;         ///< time blocks of the measurement
  double path_over_slip;   ///< see `millwear::path_over_slip`
  wear::PackedLoad bins;   ///< for `bins.h5`
  LoadAlongProfile along;  ///< without the places of its bins
  Impacts impacts;
  std::vector<double> hit_power;         ///< see hit_power.h
  std::optional<wear::PolarLoad> polar;  ///< loads of older programs have none
  std::string spectrum_lines;            ///< of `spectra.csv`
};

/// The load of a cycle whose DEM is published. `load_hash` is of its load.h5. It is worked out once
/// and kept beside the cycle. Throws DiskError, and ResultRejected where the load is damaged.
[[nodiscard]] CycleLoad load_of_cycle(const Campaign& campaign, int cycle,
                                      const std::string& load_hash);

/// The same for who only looks at a campaign that another process may be running in: what is worked
/// out is not kept.
[[nodiscard]] CycleLoad look_at_load_of_cycle(const Campaign& campaign, int cycle,
                                              const std::string& load_hash);

/// As the first with the hash of the file as it is.
[[nodiscard]] CycleLoad load_of_cycle(const Campaign& campaign, int cycle);

/// The load on the liner that it was measured on, `dem_liner`; `time` is when [s].
[[nodiscard]] wear::TimedLoad timed_load(double time, const LinerProfile& dem_liner,
                                         const CycleLoad& load);

}  // namespace millwear::orchestrator
