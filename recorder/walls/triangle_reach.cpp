#include "recorder/walls/triangle_reach.h"

#include <algorithm>
#include <cmath>

namespace millwear::recorder {
namespace {

// Far above all rounding, and above the 1e-8 m by which LIGGGHTS takes triangles for larger.
constexpr double radii_near = 1.001;

std::array<double, 4> heights(const TrianglePlanes& triangle, const double* point) {
  std::array<double, 4> above;
  for (std::size_t k = 0; k < 4; ++k)
    above[k] = triangle.normal[0][k] * point[0] + triangle.normal[1][k] * point[1] +
               triangle.normal[2][k] * point[2] - triangle.height[k];
  return above;
}

}  // namespace

TrianglePlanes planes_of(const double* corners, const double* normal, const double* edge_normals) {
  TrianglePlanes planes;
  for (std::size_t k = 0; k < 4; ++k) {
    const double* const along = k == 0 ? normal : edge_normals + 3 * (k - 1);
    const double* const on = k == 0 ? corners : corners + 3 * (k - 1);
    for (std::size_t axis = 0; axis < 3; ++axis) planes.normal[axis][k] = along[axis];
    planes.height[k] = along[0] * on[0] + along[1] * on[1] + along[2] * on[2];
  }
  return planes;
}

std::size_t find_within_reach(const TrianglePlanes& triangle, const SphereTable& spheres,
                              std::span<const int> candidates, std::span<int> near) {
  const TrianglePlanes planes = triangle;
  std::size_t count = 0;
  for (const int i : candidates) {
    const auto above = heights(planes, spheres.centres + 3 * static_cast<std::ptrdiff_t>(i));
    const double farthest =
        std::max(std::max(std::abs(above[0]), above[1]), std::max(above[2], above[3]));
    // Written first and counted if near: which one is near no processor foresees.
    near[count] = i;
    count += farthest <= radii_near * spheres.radii[i] ? 1 : 0;
  }
  return count;
}

}  // namespace millwear::recorder
