#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "wear/evolve/load_in_time.h"

namespace millwear::wear {

/// A load that is known as a function of the liner's shape, and the liner that it must leave.
struct ClosedFormLoad {
  std::string name;
  LinerProfile fresh;
  double duration;            ///< of milling [s]
  double wear_scale;          ///< section that worn shares are of [m2]
  double coarsest_threshold;  ///< that `refined` begins with
  double coarsest_tolerance;
  std::function<double(const LinerProfile&, double)> rate;  ///< depth rate at an arc length [m/s]
  /// The worst error of a liner after `duration`, as a share of the depth worn.
  std::function<double(const LinerProfile&)> error;
};

/// A ring that wears at v0 (1 + a d), d the depth worn so far: d(t) = (exp(a v0 t) - 1) / a. It
/// wears three times as fast in the end as in the beginning.
[[nodiscard]] ClosedFormLoad growing_rate();

/// A round top that wears at v0 (1 + b sin(u)), u the angle of its normal. The support function of
/// the steel falls at the rate of its direction, h(u, t) = h(u, 0) - v(u) t.
[[nodiscard]] ClosedFormLoad rate_by_slope();

/// The ring under an even rate.
[[nodiscard]] ClosedFormLoad even_rate();

/// What a campaign on such a load costs and gives.
struct ClosedFormRun {
  int loads;     ///< asked for
  double error;  ///< of its last liner, share of the depth worn
};
[[nodiscard]] ClosedFormRun run(const ClosedFormLoad& load, const CampaignSettings& settings);

/// Three runs of a scheme, coarse to fine: the threshold halves, or the tolerance is quartered,
/// from one to the next.
[[nodiscard]] std::vector<ClosedFormRun> refined(const ClosedFormLoad& load, Scheme scheme);

/// Loads that it takes to come to `error`, by the slope of the logarithms between the two runs
/// beside it or the last two.
[[nodiscard]] double loads_for(double error, const std::vector<ClosedFormRun>& runs);

/// Order of convergence: minus the slope of log(error) over log(loads) between the last two runs.
[[nodiscard]] double order_of(const std::vector<ClosedFormRun>& runs);

}  // namespace millwear::wear
