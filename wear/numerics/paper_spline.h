#pragma once
#include <Eigen/Core>

#include "wear/numerics/linear_smoother.h"

namespace millwear::wear {

/// Break points of the least-squares spline on one pitch, fewer where there are not twice as many
/// bins.
inline constexpr Eigen::Index paper_break_points = 32;

/// The 2006 paper's two splines as one smoother of `bins` (>= 8) even bins: a periodic cubic spline
/// through the values, then the periodic cubic spline on `paper_break_points` even break points
/// that is nearest to it, in least squares over eight places a bin. It is the same for every load
/// and knows of no noise, so it has no bias modes of its own. docs/physics.md says what the paper
/// leaves open. Throws ResultRejected with GSL's reason where that fails.
[[nodiscard]] LinearSmoother paper_spline(Eigen::Index bins);

}  // namespace millwear::wear
