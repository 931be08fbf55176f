#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// A place where a liner's surface turns: an edge, or a foot.
struct Edge {
  double arc_length;  ///< [m], 0 ... length
  double turn;        ///< of the surface [rad]: > 0 at an edge, < 0 at a foot
};

/// Where the chord of `window` [m] after a node turns by `least_turn` [rad] or more against that
/// before it, no two nearer than the window: the greatest turn first, then the greatest of what is
/// left. Ripples shorter than the window are no edges, and an edge that wears round is one no more
/// as soon as its radius exceeds window / least_turn. In the order of `arc_length`. Both are above
/// zero (std::logic_error).
[[nodiscard]] std::vector<Edge> edges_of(const LinerProfile& profile, double window,
                                         double least_turn);

/// Curvature at the centre of each of `bins` even bins [1/m], > 0 on a crest: the turn of the chord
/// of `window` [m] after it against that before it, over the window.
[[nodiscard]] Eigen::VectorXd curvature_along(const LinerProfile& profile, Eigen::Index bins,
                                              double window);

}  // namespace millwear::wear
