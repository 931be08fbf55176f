#include "wear/numerics/segment_distance.h"

#include <algorithm>

namespace millwear::wear {

double distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                           const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

}  // namespace millwear::wear
