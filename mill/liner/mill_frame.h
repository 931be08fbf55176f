#pragma once
#include <Eigen/Core>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// A point of the mill's section in the master lifter's frame, and the lifter it lies on.
struct MasterPoint {
  Eigen::Vector2d position;  ///< (xi, eta) [m]
  int row;                   ///< 0 ... rows - 1
};

/// The mill turns about +y; gravity is -z. At mill angle 0 lifter 0 stands at six o'clock, so that
/// its master frame is (xi, eta) = (-x, z + plate_radius); lifter k stands k pitches further along
/// the direction of rotation, and x < 0 is the side that rises.

/// Angle of a place of the mill [rad] from six o'clock along the direction of rotation, in (-pi,
/// pi].
[[nodiscard]] double angle_from_six_oclock(double x, double z);

/// The same angle as results give it [rad]: from three o'clock on the rising side along the
/// rotation, 0 ... 2 pi.
[[nodiscard]] double from_three_oclock(double angle_from_six);

/// Turns (x, z) [m] back by the mill's angle [rad] and folds it into the sector of one lifter.
[[nodiscard]] MasterPoint to_master(const LinerSector& sector, double x, double z,
                                    double mill_angle);

/// The same for a place at `radius` [m] from the axis and `angle` from six o'clock [rad].
[[nodiscard]] MasterPoint to_master_from_polar(const LinerSector& sector, double radius,
                                               double angle, double mill_angle);

/// The place (x, z) [m] of a point of the master frame on lifter `row` at the mill's angle [rad].
[[nodiscard]] Eigen::Vector2d to_mill(const LinerSector& sector, const Eigen::Vector2d& point,
                                      int row, double mill_angle);

}  // namespace millwear
