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

/// Section of steel over one pitch, between the profile and the shell [m2].
[[nodiscard]] double steel_area(const LinerProfile& profile);

/// Section of the lifter alone [m2]: the steel that stands above the new plate.
[[nodiscard]] double lifter_area(const LinerProfile& profile);

/// Least distance of the profile from the mill's axis [m]: the crest of the lifter.
[[nodiscard]] double crest_radius(const LinerProfile& profile);

/// Height of the lifter [m]: how far its crest stands above where the plate was when new. It only
/// falls, and below 0 the crest is under the new plate. The lift that the charge feels is this plus
/// what the plate has lost.
[[nodiscard]] double lifter_height(const LinerProfile& profile);

/// Least thickness of steel over the shell anywhere on the profile [m].
[[nodiscard]] double plate_thickness(const LinerProfile& profile);

/// Mean inclination of the leading face against the radial direction [rad]: 0 stands upright, pi/2
/// lies flat. The least-squares line through the face between 20 and 80 % of the lifter's height.
[[nodiscard]] double leading_face_angle(const LinerProfile& profile);

/// The same profile run backwards: xi changes sign. Used for the other sense of rotation.
[[nodiscard]] LinerProfile mirrored(const LinerProfile& profile);

/// Indices of the first pair of segments that cross (over the pitch and its two neighbours), or
/// {-1, -1} where the profile is simple.
[[nodiscard]] std::pair<int, int> first_crossing(const LinerProfile& profile);

}  // namespace millwear
