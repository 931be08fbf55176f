#pragma once
#include <Eigen/Core>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/load_in_time.h"

namespace millwear::wear {

/// A liner whose wear is not known exactly: other liners that the same mill may have worn, each as
/// a displacement of the predicted surface. First order: displacements are small to the features of
/// the profile.
struct LinerReplicates {
  LinerProfile profile;    ///< as predicted
  Eigen::MatrixXd deeper;  ///< bins x replicates [m]: along the inward normal at the centres of
                           ///< even bins of `profile`; below zero where a replicate is less worn
};

/// `count` replicates that all are the predicted liner.
[[nodiscard]] LinerReplicates same_liners(const LinerProfile& profile, Eigen::Index bins,
                                          Eigen::Index count);

/// The load of a cycle with what is not known of it.
struct UncertainLoad {
  LoadInTime load;
  Eigen::MatrixXd newest;    ///< bins x replicates [m/s]: deviations of the newest load's rate
  Eigen::MatrixXd previous;  ///< likewise of the load before; not looked at where there is none
  double growth;             ///< d ln(rate) / d(worn section) [1/m2], of the liner as it wears
};

/// The replicates after a geometry step that took `duration` [s] from `start` [s] and left the
/// predicted liner as `after`. Replicate r deepens by
///     d' = e_r(s, t) + v(s, t) growth a_r,     a_r = int d ds,
/// e_r its deviation from the rate v: what is ahead by a section a_r wears at the rate that the
/// liner comes to when it has lost as much more. It is linear, so deviations that sum to zero along
/// the profile take no section; where little wears a replicate's rate may be below zero.
/// Displacements are carried along with the surface (`LoadCarrier`).
[[nodiscard]] LinerReplicates worn(const LinerReplicates& before, const UncertainLoad& load,
                                   double start, double duration, const LinerProfile& after);

/// The same liners as a reversed mill turns them (mill/liner/rotation.h).
[[nodiscard]] LinerReplicates mirrored(const LinerReplicates& liners);

/// Growth of the rate between two loads, d ln(rate) / d(worn section) [1/m2], with the share of the
/// change that its noise explains left out (as in `LoadInTime`). Zero where no steel went between.
[[nodiscard]] double growth_between(const TimedLoad& before, const TimedLoad& after);

/// Lifter height and least plate thickness of every replicate [m], as `lifter_height` and
/// `plate_thickness` are of the predicted liner.
[[nodiscard]] Eigen::VectorXd lifter_heights(const LinerReplicates& liners);
[[nodiscard]] Eigen::VectorXd plate_thicknesses(const LinerReplicates& liners);

/// Section of steel that every replicate has lost more than predicted [m2].
[[nodiscard]] Eigen::VectorXd sections_ahead(const LinerReplicates& liners);

}  // namespace millwear::wear
