#pragma once
#include <array>
#include <span>

namespace millwear::recorder {

/// Unit quaternion of a turn by `angle` about a unit axis a: (cos(angle / 2), sin(angle / 2) a).
using Quaternion = std::array<double, 4>;

using Triple = std::array<double, 3>;

/// How a mesh turns: about an axis through `centre`.
struct Turn {
  Quaternion quaternion;
  Triple centre = {};  ///< [m]
};

/// Speed of a turn about an axis through `centre`.
struct TurningSpeed {
  Triple spin;         ///< along the axis [rad/s]
  Triple centre = {};  ///< [m]
};

// What follows takes vectors as LIGGGHTS keeps those of a mesh: x, y and z of the first, then of
// the second, ... The processor's vector units work on several at once. Every sum is in LIGGGHTS's
// order, so that all results have its bits: `MathExtraLiggghts::vec_quat_rotate`,
// `MultiNodeMesh::rotate` and `MeshMoverRotate::initial_integrate` of LIGGGHTS 3.8.

/// Turns directions v in place: v becomes q (0, v) q*.
void turn_directions(std::span<double> directions, const Quaternion& quaternion);

/// Turns points in place.
void turn_points(std::span<double> points, const Turn& turn);

/// Mean of the three corners of every triangle.
void find_centres(std::span<const double> corners, std::span<double> centres);

/// Velocity of every point: spin x (point - centre) [m/s].
void find_velocities(std::span<const double> points, const TurningSpeed& speed,
                     std::span<double> velocities);

}  // namespace millwear::recorder
