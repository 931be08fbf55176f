#pragma once
#include <vector>

#include "mill/case/charge.h"
#include "mill/case/wear_settings.h"
#include "mill/load/wall_load.h"
#include "wear/rate/smoothing.h"

namespace millwear::wear {

/// A load as bins and as the loss of steel it stands for.
struct LoadRate {
  WallLoad load;        ///< on the settings' bins
  Eigen::VectorXd raw;  ///< depth rate of every bin [m/s]
  /// The same from each time block, bins x blocks, scattered as independent ones
  /// (`as_independent`).
  Eigen::MatrixXd by_block;
  SmoothedLoss smoothed;  ///< the same, smoothed along the profile, with its errors
};

/// How the loads of a charge are smoothed: by the settings' method, and resolved no finer along the
/// profile than the radius of the smallest particle.
[[nodiscard]] Smoothing smoothing_of(const WearSettings& settings,
                                     const std::vector<ParticleClass>& classes);

/// Lays the settings' bins on a recorded load, applies their mechanisms and smooths the loss that
/// goes with contacts. Corrosion is the same everywhere, has no error, and is added after the
/// smoothing. `classes` are those that the load was recorded by.
/// Throws as `coarsened`, `depth_rate` and `smoothed` do.
[[nodiscard]] LoadRate rate_of_load(const WearSettings& settings,
                                    const std::vector<ParticleClass>& classes,
                                    const WallLoad& recorded);

}  // namespace millwear::wear
