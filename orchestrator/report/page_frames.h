#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wear/charge/charge_frames.h"

namespace millwear::orchestrator {

/// Frames of a charge as a page holds them: places of the first frame in 16 bits, how far each
/// particle moves to the second in 8, and from then on how much its move changes (modulo 256):
/// small numbers, which pack well. The moves add up without drift: each is the nearest to where the
/// particle is from where the moves before have brought it. Along the axis, where the
/// slice repeats itself, a particle moves the shorter way, so its place may leave `along`.
struct PageFrames {
  std::size_t thinning;               ///< every so many-th particle is kept
  std::vector<double> times;          ///< [s]
  std::vector<double> mill_angles;    ///< as of `wear::ChargeFrames` [rad]
  double step;                        ///< that a move of 1 stands for [m]
  std::vector<std::uint8_t> classes;  ///< by particle
  std::vector<std::uint16_t> first;   ///< (x, y, z) x particles
  std::vector<std::int8_t> changes;   ///< of moves, (frames - 1) x (x, y, z) x particles
};

/// Every `every`-th frame, and as many particles as `most_bytes` has room for.
[[nodiscard]] PageFrames page_frames(const wear::ChargeFrames& frames, std::size_t every,
                                     std::size_t most_bytes);

}  // namespace millwear::orchestrator
