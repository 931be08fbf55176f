#pragma once
#include <vector>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/loss_nodes.h"

namespace millwear::wear {

/// A profile after steel was taken off it.
struct MovedProfile {
  LinerProfile profile;
  double removed_area;  ///< section of steel that went [m2]
  double depth_scale;   ///< the depths were multiplied by this so that the area is the wanted
  double dropped_area;  ///< the part of it that was cut off its hold on the shell [m2]
};

/// New steel = old steel minus the region swept by the loss, over the pitch and its neighbours.
///
/// `loss` are the depths on `profile`, or on a closing of it (wear/surface/closing.h), from
/// `loss_nodes`. They are all multiplied by one factor so
/// that the section removed is `target_area` [m2], to 1e-9 of it (or to the rounding of a section,
/// 1e-14 of the shell's sector, where that is more): on a corner the swept pieces
/// overlap, at a foot they leave gaps, and the volume of the wear law decides, not the depth.
/// Steel that the loss cuts off from the shell falls away without being worn: it is removed besides
/// the target and reported as `dropped_area`.
/// The result has no crossings, gains steel nowhere (but for the 1 nm grid), and ends at the same
/// radius on both edges of the sector. Nodes that no loss touched stay exactly where they are.
/// New nodes are kept apart by about a twentieth of `resolution` [m], the width of a bin.
/// Below the shell the steel is taken to go on, so that a limit can be looked for from both sides.
/// Takes 4 rows or more and a target not below zero (std::logic_error). Throws ResultRejected where
/// nothing is lost, where the target is more steel than there is, or where no valid profile
/// results.
[[nodiscard]] MovedProfile move_profile(const LinerProfile& profile,
                                        const std::vector<LossNode>& loss, double target_area,
                                        double resolution);

}  // namespace millwear::wear
