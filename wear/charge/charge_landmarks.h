#pragma once
#include <Eigen/Core>

#include "wear/charge/charge_fields.h"

namespace millwear::wear {

/// Where the charge stands in the mill, after its mean fields. Places (x, z) in the mill frame [m];
/// angles from three o'clock on the rising side along the rotation [rad], as of `ChargePosition`.
/// NaN where the fields have no such place.
struct ChargeLandmarks {
  double shoulder;         ///< where the bulk of the charge leaves the lifters
  double bulk_toe;         ///< where it meets them again
  Eigen::Vector2d head;    ///< the highest place that the charge reaches
  Eigen::Vector2d centre;  ///< of circulation: the bulk turns around it
};

/// Shoulder and bulk toe are where the occupied share falls below half of its 90th percentile, on a
/// circle of `radius` [m] just inside the lifters' crests, left and right of where it is fullest.
/// The head is the highest cell that is occupied for more than a hundredth of the time. The centre
/// of circulation is where the stream function of the mean flow,
///     psi(x, z) = int rho v_z dx from the wall of the rising side to x,
/// is greatest: there v_x and v_z change their signs.
/// Source of the terms: Powell & Nurick (1996), Minerals Engineering 9, 259.
[[nodiscard]] ChargeLandmarks landmarks_of(const ChargeFields& fields, double radius);

}  // namespace millwear::wear
