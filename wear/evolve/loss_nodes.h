#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// A place of the profile and the depth of steel lost there, linear to the next place.
struct LossNode {
  Eigen::Vector2d position;  ///< (xi, eta) [m]
  double depth;              ///< lost along the inward normal [m], >= 0
};

/// Every node of the profile, and places between them so that no two are farther apart than half
/// of `resolution` [m]; the depth at each by `depth_at` of its arc length [m], the last the same as
/// the first because they are the same place of two pitches. An edge is two nodes, with the depths
/// a twentieth of the resolution before it and after it: each of its faces moves by its own.
[[nodiscard]] std::vector<LossNode> loss_nodes(const LinerProfile& profile, double resolution,
                                               const std::function<double(double)>& depth_at);

/// Section of steel the nodes stand for, int depth ds by the trapezoidal rule [m2].
[[nodiscard]] double loss_area(const std::vector<LossNode>& nodes);

/// The same nodes with every depth multiplied by `factor`.
[[nodiscard]] std::vector<LossNode> scaled(std::vector<LossNode> nodes, double factor);

/// The nodes on the pitch before, on this one and on the next, each shared edge once.
[[nodiscard]] std::vector<LossNode> over_three_pitches(const LinerSector& sector,
                                                       const std::vector<LossNode>& nodes);

using Polygon = std::vector<Eigen::Vector2d>;

/// The region that the surface sweeps while it moves into the steel: a trapezoid for every pair of
/// neighbouring nodes along its own inward normal. Where two normals diverge (a foot of the lifter)
/// by less than 15 degrees the trapezoids meet at the mitre, else a fan of the node's depth fills
/// the gap, so that no spike is left. The pieces overlap; take their union. Zero depths are left
/// out.
[[nodiscard]] std::vector<Polygon> swept_region(const std::vector<LossNode>& nodes);

}  // namespace millwear::wear
