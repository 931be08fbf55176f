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
  /// By bins of the newest load's liner: how fast the rate grows there, d ln(rate) / dt [1/s].
  Eigen::VectorXd growth;
};

/// The replicates after a geometry step that took `duration` [s] from `start` [s] and left the
/// predicted liner as `after`. Replicate r deepens by
///     d' = path e_r(s, t) + growth d + f r (d2d/ds2 + kappa^2 d),
/// e_r its deviation from the rate f of a flat. What is ahead by d has the rate that the place
/// comes to when it has lost as much more; the last term is what balls of radius r do to a surface
/// that is displaced by d (wear/evolve/surface_loss.h). It is linear, so where little wears a
/// replicate's rate may be below zero. Displacements are carried along with the surface
/// (`LoadCarrier`).
[[nodiscard]] LinerReplicates worn(const LinerReplicates& before, const UncertainLoad& load,
                                   double start, double duration, const LinerProfile& after);

/// The same liners as a reversed mill turns them (mill/liner/rotation.h).
[[nodiscard]] LinerReplicates mirrored(const LinerReplicates& liners);

/// Growth of the rate between two loads by bins of a liner between theirs, 2 (f2 - f1) / (f1 + f2)
/// over the time between them [1/s], with the share of the change that its noise explains left out
/// (as in `LoadInTime`).
[[nodiscard]] Eigen::VectorXd growth_between(const TimedLoad& before, const TimedLoad& after,
                                             const LinerProfile& liner);

/// Lifter height and least plate thickness of every replicate [m], as `lifter_height` and
/// `plate_thickness` are of the predicted liner.
[[nodiscard]] Eigen::VectorXd lifter_heights(const LinerReplicates& liners);
[[nodiscard]] Eigen::VectorXd plate_thicknesses(const LinerReplicates& liners);

/// Section of steel that every replicate has lost more than predicted [m2].
[[nodiscard]] Eigen::VectorXd sections_ahead(const LinerReplicates& liners);

}  // namespace millwear::wear
