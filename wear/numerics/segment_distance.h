#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// Distance of a point from the straight piece between two others [m]; from the one place where
/// these are the same.
[[nodiscard]] double distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                                         const Eigen::Vector2d& to);

}  // namespace millwear::wear
