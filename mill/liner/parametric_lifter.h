#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear {

/// A lifter with a flat top and two straight faces that stands upright on the plate.
/// Face angles are measured from the radial direction at the lifter's centre [rad]: 0 is upright,
/// in [0, pi/2). The industry calls the leading one the release angle.
struct ParametricLifter {
  double height;               ///< of the top over the plate at the lifter's centre [m]
  double top_width;            ///< [m]
  double leading_face_angle;   ///< [rad]
  double trailing_face_angle;  ///< [rad]
  double top_radius = 0.0;     ///< between top and faces [m]
  double foot_radius = 0.0;    ///< between faces and plate [m]; of an arc only
};

/// How the plate runs from one lifter to the next.
enum class PlateShape {
  arc,       ///< the true circle, cut into facets
  straight,  ///< a straight line from foot to foot, as the 2006 paper drew it
};

/// The farthest a facet of the plate may lie from its circle [m].
inline constexpr double plate_sagitta = 1e-4;

/// The profile of `lifter` in its sector. Its faces end on the plate's circle. Radii are cut into
/// facets that lie within a hundredth of the radius of it.
/// Throws InputError where the lifters of neighbouring rows overlap or reach the mill's axis, and
/// where a radius finds no room.
[[nodiscard]] LinerProfile profile_of(const LinerSector& sector, const ParametricLifter& lifter,
                                      PlateShape plate = PlateShape::arc);

/// Nodes on the circle of `radius` [m] after `from` and before `to` [rad], such that no facet lies
/// farther than `plate_sagitta` from the circle:  radius (1 - cos(step/2)) <= plate_sagitta.
[[nodiscard]] std::vector<Eigen::Vector2d> nodes_between(const LinerSector& sector, double radius,
                                                         double from, double to);

}  // namespace millwear
