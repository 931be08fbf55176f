#pragma once
#include <Eigen/Core>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// Zones of a pitch: equal angles about the mill's axis, from the trailing sector edge on. Zone z
/// of Z reaches from pitch (z / Z - 1/2) to pitch ((z + 1) / Z - 1/2); what lies beyond the
/// sector's edges is in the zone of the neighbouring pitch that has its place there.

/// The zone of a point of the master frame, 0 ... zones - 1.
[[nodiscard]] Eigen::Index zone_of(const LinerSector& sector, const Eigen::Vector2d& point,
                                   Eigen::Index zones);

/// Section of steel between the profile and the shell in every zone [m2], size `zones`, exact for
/// the polyline; their sum is `steel_area`. Faces may lean over.
[[nodiscard]] Eigen::VectorXd steel_by_zone(const LinerProfile& profile, Eigen::Index zones);

/// Length of the profile in every zone [m], size `zones`.
[[nodiscard]] Eigen::VectorXd length_by_zone(const LinerProfile& profile, Eigen::Index zones);

}  // namespace millwear::wear
