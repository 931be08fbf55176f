#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear {

/// Where the master lifter stands: the circle of the new plate and the sector of one lifter.
///
/// The master frame has its origin on the new plate at the lifter's centre, xi along the direction
/// of rotation and eta towards the mill's axis, so the axis is at (0, plate_radius) and the new
/// plate is the circle xi^2 + (eta - plate_radius)^2 = plate_radius^2.
struct LinerSector {
  double shell_radius;  ///< inside the shell, under the plate [m]
  double plate_radius;  ///< on the new plate [m], < shell_radius
  int rows;             ///< lifters around the mill

  [[nodiscard]] double pitch() const;  ///< 2 pi / rows [rad]
};

/// The liner's surface over one pitch: a polyline in the master frame [m], ordered by the angle
/// around the mill from the trailing sector edge (-pitch/2) to the leading one (+pitch/2).
/// Its two ends are the same point of two neighbouring pitches; steel lies below (larger radius).
struct LinerProfile {
  LinerSector sector;
  std::vector<Eigen::Vector2d> nodes;  ///< (xi, eta) [m], at least 3
};

/// Points nearer than this are one [m]: no drawing and no gauge tells them apart, and a file with
/// six decimals does not either.
inline constexpr double same_point = 1e-6;

/// Distance of a point of the master frame from the mill's axis [m].
[[nodiscard]] double radius_of(const LinerSector& sector, const Eigen::Vector2d& point);

/// Angle of a point of the master frame about the mill's axis [rad], 0 at the lifter's centre,
/// positive along the direction of rotation.
[[nodiscard]] double angle_of(const LinerSector& sector, const Eigen::Vector2d& point);

/// The point of the master frame at a radius [m] and an angle [rad].
[[nodiscard]] Eigen::Vector2d point_at(const LinerSector& sector, double radius, double angle);

/// `point` carried `pitches` whole pitches along the direction of rotation [m].
[[nodiscard]] Eigen::Vector2d shifted_by_pitches(const LinerSector& sector,
                                                 const Eigen::Vector2d& point, int pitches);

/// Arc length of every node from the first one [m], size nodes.size(); the last is the whole
/// length.
[[nodiscard]] std::vector<double> arc_lengths(const LinerProfile& profile);

/// The same profile run backwards: xi changes sign. Used for the other sense of rotation.
[[nodiscard]] LinerProfile mirrored(const LinerProfile& profile);

}  // namespace millwear
