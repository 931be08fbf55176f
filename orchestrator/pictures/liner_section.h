#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "orchestrator/pictures/scene.h"

namespace millwear::orchestrator {

/// Places (x, z) in the mill frame [m].
using Outline = std::vector<Eigen::Vector2d>;

/// The steel of every lifter row between profile and shell, as closed outlines.
[[nodiscard]] std::vector<Outline> steel_outlines(const LinerProfile& liner, double mill_angle);

/// The liner of a slice from y = 0 to `length` [m] as triangles: its surface, and its cut face at
/// y = 0.
[[nodiscard]] std::vector<Triangle> cut_liner(const LinerProfile& liner, double mill_angle,
                                              double length);

}  // namespace millwear::orchestrator
