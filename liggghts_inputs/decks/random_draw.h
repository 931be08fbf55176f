#pragma once
#include <random>

namespace millwear::liggghts {

/// A draw in [0, 1) that is the same on every platform.
[[nodiscard]] inline double uniform_draw(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace millwear::liggghts
