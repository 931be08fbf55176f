#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace millwear::meshgen {

/// Vertices of a triangle, counter-clockwise seen from the charge.
using Triangle = std::array<int, 3>;

/// Triangles that share their vertices [m].
struct Triangulation {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

}  // namespace millwear::meshgen
