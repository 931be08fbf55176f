#pragma once
#include <Eigen/Core>
#include <vector>

#include "wear/evolve/loss_nodes.h"

namespace millwear::wear {

/// Clipper's integer grid [m].
inline constexpr double clipping_grid = 1e-9;

struct SteelCut {
  std::vector<Eigen::Vector2d> surface;  ///< what is left of the surface, from end to end
  std::vector<Polygon> dropped;          ///< pieces of steel that lost their hold on the shell
};

/// Old steel minus the swept region. The steel lies between `surface`, ordered along the direction
/// of rotation, and `bottom`, ordered the same way; the piece that holds the ends of `bottom`
/// stays. Nodes of `surface` that are left come back exactly, all others on the grid. Throws
/// ResultRejected where the region cuts the bottom off.
[[nodiscard]] SteelCut cut(const std::vector<Eigen::Vector2d>& surface,
                           const std::vector<Eigen::Vector2d>& bottom,
                           const std::vector<Polygon>& swept);

}  // namespace millwear::wear
