#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "mill/case/campaign_settings.h"
#include "mill/liner/rotation.h"
#include "wear/band/life_band.h"
#include "wear/band/liner_replicates.h"
#include "wear/evolve/load_in_time.h"

namespace millwear::wear {

/// What a geometry step took and left.
struct WornStep {
  double duration;       ///< [s]
  LinerProfile profile;  ///< at its end
};

/// A cycle of a campaign: its load, what is not known of it, and the steps that were taken on it,
/// all on the liner as the DEM turns it.
struct WornCycle {
  TimedLoad load;
  Eigen::MatrixXd deviations;  ///< bins x replicates [m/s], of `rate_replicates`
  std::vector<WornStep> steps;
  Rotation rotation = Rotation::as_new;
  /// The mill was operated the same way in the cycle before: their loads are of one charge.
  bool continues = true;
};

/// What is not known of the liner after a step, on the liner as the DEM turns it. Standard errors
/// are over the replicates.
struct LinerBand {
  ReplicatesInTime replicates;
  double height_error;          ///< [m]
  double plate_error;           ///< [m]
  double section_error;         ///< of the section worn [m2]
  Eigen::VectorXd depth_error;  ///< by even bins of the step's profile, along its normal [m]
};

/// The uncertainty of a campaign, from the scatter between the time blocks of its loads: a band
/// after every step of every cycle. Each load has its own noise; it is carried through smoothing
/// (in `deviations`), geometry (`LinerReplicates`) and time (`LoadInTime`, and the growth of the
/// rate between a cycle's load and the next). Not in it: the errors of the wear law, of the DEM and
/// of the steps in time.
[[nodiscard]] std::vector<std::vector<LinerBand>> bands_of(std::span<const WornCycle> cycles,
                                                           Scheme scheme);

/// The band of a cycle of some that follow each other also looks at as many before and after it,
/// where there are so many: at their loads, and of the one before at its deviations and rotation.
inline constexpr std::size_t band_looks_aside_before = 2;
inline constexpr std::size_t band_looks_aside_after = 3;

/// A cycle's part of `bands_of`.
struct CycleBand {
  std::vector<LinerBand> steps;
  LinerReplicates after;  ///< the liners after the cycle, as the DEM turns it
  double load_scatter;    ///< `birge_ratio` of the loads about it, by which it is widened [-]
};

/// The band of cycle number `cycle` of `cycles`, to which the cycle before has left the replicates
/// `before`. With what it looks at the same as by `bands_of`, bit for bit.
[[nodiscard]] CycleBand band_of_cycle(std::span<const WornCycle> cycles, std::size_t cycle,
                                      const LinerReplicates& before, Scheme scheme);

/// The replicates that the first cycle of a campaign begins with: its liner.
[[nodiscard]] LinerReplicates first_replicates(const WornCycle& first);

/// Lives of the replicates [s], see `lives`; empty for a campaign without a step.
[[nodiscard]] Eigen::VectorXd lives_of(std::span<const WornCycle> cycles,
                                       const std::vector<std::vector<LinerBand>>& bands,
                                       const CampaignSettings& limits);

}  // namespace millwear::wear
