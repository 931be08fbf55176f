#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

#include "mill/case/campaign_settings.h"
#include "mill/liner/liner_profile.h"
#include "wear/evolve/load_carrier.h"
#include "wear/evolve/timed_load.h"
#include "wear/numerics/arc_curve.h"

namespace millwear::wear {

/// Those of the loads since the liner was new (or since the mill's rotation was reversed) that a
/// scheme looks at: the newest, or all.
[[nodiscard]] std::span<const TimedLoad> in_use(std::span<const TimedLoad> loads, Scheme scheme);

/// The load on a liner that wears on after its last measurement:
///     v(t) = v_n + (t - t_n) g,   g = f (v_n - v_(n-1)) / (t_n - t_(n-1)),   not below zero,
/// the rates of a flat surface, with those of both loads carried along with the surface
/// (`LoadCarrier`). With one load g = 0. Two measured loads differ by their noise already, so the
/// change is believed only in the share that noise does not explain, f = max(0, 1 - 2 s2 / d2), d2
/// the squares of the difference between the loads summed over zones of the liner (`zoned`) and s2
/// the squares of its standard errors (after James and Stein 1961, Proc. 4th Berkeley Symp. 1, 361;
/// twice the noise, because few zones bear the load and chance passes it once easily): exact loads
/// are extrapolated wholly, noise is not.
class LoadInTime {
 public:
  /// The newest load last; only the last two count. There is at least one, and their times
  /// increase (std::logic_error).
  explicit LoadInTime(std::span<const TimedLoad> loads);

  /// Carries what stands on the newest load's liner onto profiles worn from it.
  [[nodiscard]] const LoadCarrier& carrier() const { return carrier_; }

  /// The liner that the newest load was measured on.
  [[nodiscard]] const LinerProfile& liner() const { return newest_.profile; }

  /// Depth rate of a flat surface at the bins of the newest load's liner, not below zero [m/s].
  [[nodiscard]] Eigen::VectorXd per_path(double time) const;

  /// Section that is lost of the newest load's liner [m2/s].
  [[nodiscard]] double section_rate(double time) const;

  [[nodiscard]] const RollingBalls& balls() const { return newest_rolling_.balls; }
  [[nodiscard]] double corrosion() const { return newest_rolling_.corrosion; }

  /// The same sum of other quantities that go with the two loads, bins x any, not cut; `previous`
  /// is not looked at where only one load counts.
  [[nodiscard]] Eigen::MatrixXd sum(double time, const Eigen::MatrixXd& newest,
                                    const Eigen::MatrixXd& previous) const;

  /// The load by zones of a liner that was worn under it, not cut.
  [[nodiscard]] ZonedLoad predicted(const LinerProfile& worn, double time) const;

 private:
  /// Factor of the previous load at a time; that of the newest is 1 minus this.
  [[nodiscard]] double share_of_previous(double time) const;

  TimedLoad newest_;
  Rolling newest_rolling_;
  LoadCarrier carrier_;
  std::optional<TimedLoad> previous_;
  Eigen::VectorXd previous_per_path_;
  LoadCarrier::Rows previous_onto_newest_;
  double believed_ = 0.0;  ///< f
};

}  // namespace millwear::wear
