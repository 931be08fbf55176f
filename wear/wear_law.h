#pragma once
#include <Eigen/Core>

#include "mill/wall_load.h"

namespace millwear::wear {

/// Archard's law: worn volume grows with normal force times sliding distance,
///     dV/dt = k Fn |v_slip|,   k = K / H.
/// Valid for sliding contacts; a rolling or purely normal contact wears nothing.
/// Source: Archard (1953), J. Appl. Phys. 24, 981.
struct Archard {
  double specific_wear_rate;  ///< k [1/Pa], >= 0
};

/// Wear depth rate of each bin [m/s of milling], size = load.bins():
///     k W / (A rows T),   W the sliding work [J], A the bin's area on one lifter [m2].
/// `load` holds the sliding work per bin, summed over `rows` lifters and `duration` T seconds.
/// Throws InputError if a bin has no area, or the load no rows or duration.
[[nodiscard]] Eigen::VectorXd depth_rate(const Archard& law, const WallLoad& load);

/// The same from each time block alone, over the block's own duration T / block_count [m/s],
/// load.bins() x load.block_count. The mean over the blocks is `depth_rate`.
[[nodiscard]] Eigen::MatrixXd depth_rate_by_block(const Archard& law, const WallLoad& load);

}  // namespace millwear::wear
