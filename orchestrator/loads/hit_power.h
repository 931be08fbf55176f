#pragma once
#include <Eigen/Core>
#include <vector>

#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// Arc of `hit_power` [degrees].
inline constexpr Eigen::Index hit_arc_degrees = 5;

/// Power of hits on the bare liner [W per degree], a value an arc from twelve o'clock along the
/// rotation; empty where it was not recorded.
[[nodiscard]] std::vector<double> hit_power(const wear::LinerRecord& record);

}  // namespace millwear::orchestrator
