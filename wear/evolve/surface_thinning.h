#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear::wear {

/// A node of a worn surface.
struct SurfaceNode {
  Eigen::Vector2d position;  ///< (xi, eta) [m]
  double depth;              ///< how deep it lies under the surface it was worn from [m]
  bool fixed;                ///< a node of that surface, or an end: stays where it is
};

/// Drops nodes that the shape can do without, so that their number stays bounded over many steps:
/// those within 1 um of the line that replaces them, and those closer than `closest` [m] to a
/// neighbour. Never a fixed node, and never one whose loss would lift the surface by more than half
/// of the node's own depth: no steel comes back. Nodes of no depth go only off straight lines.
[[nodiscard]] std::vector<SurfaceNode> thinned(const std::vector<SurfaceNode>& surface,
                                               double closest);

}  // namespace millwear::wear
