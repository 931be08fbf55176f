#pragma once
#include <vector>

#include "mill/case/charge.h"
#include "mill/case/wear_settings.h"
#include "mill/liner/liner_profile.h"
#include "mill/load/wall_load.h"
#include "wear/rate/smoothing.h"
#include "wear/surface/centre_path.h"

namespace millwear::wear {

/// A load as bins and as the loss of steel it stands for.
struct LoadRate {
  WallLoad load;        ///< on the settings' bins
  Eigen::VectorXd raw;  ///< depth rate of every bin [m/s]
  /// The same from each time block, bins x blocks, scattered as independent ones
  /// (`as_independent`).
  Eigen::MatrixXd by_block;
  Smoothing how;          ///< by the settings' method, along the way of the balls' centres, and no
                          ///< finer than the diameter of the smallest particle
  SmoothedLoss smoothed;  ///< the same, smoothed along the profile, with its errors
  /// The smallest of the charge, whose closing of the liner wears, or none where shadowed steel is
  /// kept; and the mean, each class weighted with what it wears.
  RollingBalls balls;
  double corrosion;  ///< part of all rates but of `smoothed.per_path` [m/s]
};

/// The load as balls that roll over the liner, for a `TimedLoad`.
[[nodiscard]] Rolling rolling_of(const LoadRate& rate);

/// Lays the settings' bins on the load recorded on a liner, applies their mechanisms and smooths
/// the loss that goes with contacts. Corrosion is the same everywhere, has no error, and is added
/// after the smoothing. `classes` are those that the load was recorded by. Throws as `coarsened`,
/// `depth_rate` and `smoothed` do.
[[nodiscard]] LoadRate rate_of_load(const WearSettings& settings,
                                    const std::vector<ParticleClass>& classes,
                                    const LinerProfile& liner, const WallLoad& recorded);

/// How well a recorded load knows its rate at the peaks: `peak_error` of `rate_of_load`. Throws as
/// that does.
[[nodiscard]] double peak_error_of_load(const WearSettings& settings,
                                        const std::vector<ParticleClass>& classes,
                                        const LinerProfile& liner, const WallLoad& recorded);

}  // namespace millwear::wear
