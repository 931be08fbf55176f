#pragma once
#include <Eigen/Core>

namespace millwear::recorder {

/// A particle's place, velocity or spin in one of LIGGGHTS's tables.
[[nodiscard]] inline Eigen::Vector3d at(double** values, int particle) {
  return {values[particle][0], values[particle][1], values[particle][2]};
}

}  // namespace millwear::recorder
