#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace millwear::recorder {

/// Planes around a triangle: its own, and one through each edge at a right angle to it. Own first;
/// the normals of the others point outwards.
struct TrianglePlanes {
  std::array<std::array<double, 4>, 3> normal;  ///< x, y and z of the four unit normals
  std::array<double, 4> height;                 ///< of the four planes above the origin [m]
};

/// `corners` and `edge_normals` lie as LIGGGHTS keeps them: x, y and z of the first, of the second,
/// of the third.
[[nodiscard]] TrianglePlanes planes_of(const double* corners, const double* normal,
                                       const double* edge_normals);

/// Spheres as LIGGGHTS keeps its particles.
struct SphereTable {
  const double* centres;  ///< x, y and z of the first, of the second, ... [m]
  const double* radii;    ///< [m]
};

/// Writes to `near` which of the `candidates` may touch the triangle, in their order, and returns
/// how many: those whose centre is not above a plane by more than 1.001 radii (on either side of
/// the triangle's own). What is left out is sure not to touch. `near` has room for all.
std::size_t find_within_reach(const TrianglePlanes& triangle, const SphereTable& spheres,
                              std::span<const int> candidates, std::span<int> near);

}  // namespace millwear::recorder
