#pragma once
#include "mill/case/case.h"
#include "mill/load/wall_load.h"
#include "wear/rate/smoothing.h"

namespace millwear::wear {

/// A load as bins and as the loss of steel it stands for.
struct LoadRate {
  WallLoad load;        ///< on the case's bins
  Eigen::VectorXd raw;  ///< depth rate of every bin [m/s]
  /// The same from each time block, bins x blocks, scattered as independent ones
  /// (`as_independent`).
  Eigen::MatrixXd by_block;
  SmoothedLoss smoothed;  ///< the same, smoothed along the profile, with its errors
};

/// How a case's loads are smoothed: by its method, and resolved no finer along the profile than the
/// radius of the smallest particle.
[[nodiscard]] Smoothing smoothing_of(const Case& mill);

/// Lays the case's bins on a recorded load, applies the wear law and smooths the loss that goes
/// with contacts. Corrosion is the same everywhere, has no error, and is added after the smoothing.
/// Throws as `coarsened`, `depth_rate` and `smoothed` do.
[[nodiscard]] LoadRate rate_of_load(const Case& mill, const WallLoad& recorded);

}  // namespace millwear::wear
