#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/load_in_time.h"
#include "wear/evolve/loss_nodes.h"

namespace millwear::wear {

/// What a surface loses under rolling balls, in the open and as it changes its shape.
struct SurfaceLoss {
  std::vector<LossNode> nodes;  ///< their depths are the rates of a flat surface [m/s]
  Eigen::VectorXd turns;        ///< of the surface at every node [rad]: > 0 on a crest or an edge
  double ball_radius;           ///< r, of the mean ball [m]
  double corrosion;             ///< depth lost everywhere [m/s]
};

/// The loss at `time` on a liner worn from that of the load. Its closing by the smallest ball wears
/// (wear/surface/closing.h); under the arcs of the closing smaller particles wear as on a flat.
[[nodiscard]] SurfaceLoss surface_loss(const LinerProfile& liner, const LoadInTime& load,
                                       double time);

/// Section lost per second, sum f_i (L_i + r turn_i) with f the rate of a flat and L the length of
/// a node; nothing where that is below zero [m2/s].
[[nodiscard]] double section_rate(const SurfaceLoss& loss);

/// Depths after `duration` [s]. On a surface of curvature kappa (> 0 on a crest) the ball's centre
/// goes a way of 1 + r kappa per length, and depths d change the curvature:
///     dd/dt = f (1 + r (kappa + d2d/ds2)) + corrosion,
/// one step of implicit Euler, which is stable for any step: bumps are worn off and hollows left
/// behind, the faster the sharper they are. Never below zero. Throws ResultRejected where the
/// equations cannot be solved.
[[nodiscard]] std::vector<LossNode> depths_after(const SurfaceLoss& loss, double duration);

}  // namespace millwear::wear
