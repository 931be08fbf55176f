#pragma once
#include <Eigen/Core>
#include <optional>

#include "mill/liner/liner_profile.h"
#include "wear/numerics/arc_curve.h"
#include "wear/surface/centre_path.h"

namespace millwear::wear {

/// A measured load: the rate at which it wears the liner that it was measured on.
struct TimedLoad {
  double time;           ///< of milling since the liner was new, when it was measured [s]
  LinerProfile profile;  ///< the liner
  ArcCurve rate;         ///< depth rate along it, smoothed [m/s]
  /// The rate before it was smoothed, from each time block: bins x blocks [m/s]. Empty where `rate`
  /// is known without noise.
  Eigen::MatrixXd by_block{};
  /// How it changes with the shape; as on points, not at all, where there are none.
  std::optional<Rolling> rolling{};
};

/// Depth rate of a flat surface under a load, by its bins [m/s].
[[nodiscard]] const Eigen::VectorXd& per_path(const TimedLoad& load);

/// Section of steel that a load takes per second [m2/s].
[[nodiscard]] double section_rate(const TimedLoad& load);

/// A load summed over twelve zones of a liner, and its variance between time blocks.
struct ZonedLoad {
  Eigen::VectorXd rate;      ///< section lost per second [m2/s]
  Eigen::VectorXd variance;  ///< [m4/s2], zero for an exact load
};

/// Lays a load on even zones of another liner, worn from its own or the same: every bin's loss goes
/// to the zone of the nearest place. From one measurement to the next, zones differ by what their
/// time blocks tell, whereas bins do not: a corner moves from bin to bin as its liner wears, and
/// smoothing is now stronger, now weaker.
[[nodiscard]] ZonedLoad zoned(const TimedLoad& load, const LinerProfile& liner);

}  // namespace millwear::wear
