#pragma once
#include <Eigen/Core>

#include "wear/charge/charge_fields.h"

namespace millwear::wear {

/// How a rolling bed flows on the line from the axis through its middle, at right angles to its
/// free surface. NaN where the charge has no such bed.
struct BedProfile {
  double surface_angle;      ///< of the free surface against the horizontal [rad]
  Eigen::VectorXd depth;     ///< below the axis [m], increasing, evenly spaced
  Eigen::VectorXd velocity;  ///< along the surface, up the slope [m/s]
  double surface_depth;      ///< where the occupied share falls to half of the bed's [m]
  double surface_speed;      ///< the fastest down the slope [m/s]
  double turning_depth;      ///< where the velocity is zero [m]
};

/// `shoulder` and `bulk_toe` are the ends of the bed [rad] as `ChargeLandmarks` gives them, and
/// `radius` is the mill's [m]. The free surface is the chord between the two ends:
///     angle = (shoulder + toe) / 2 - 270 degrees.
/// Valid for a charge that rolls or slumps with a flat surface; not where much of it flies.
[[nodiscard]] BedProfile bed_profile_of(const ChargeFields& fields, double shoulder,
                                        double bulk_toe, double radius);

}  // namespace millwear::wear
