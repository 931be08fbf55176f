#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/load/wall_load.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/results/wear_rates.h"

namespace millwear::orchestrator {

/// A wear law on one load, beside the law that the campaign ran with.
struct LawOnLoad {
  double section_rate;         ///< steel that one lifter loses [m2/s]
  double campaign_rate;        ///< likewise by the campaign's law [m2/s]
  std::vector<double> shares;  ///< of each mechanism, their sum 1; NaN where nothing wears
  /// Share of the wear that falls on another place of the profile than in the campaign: half of
  /// int |p - q| ds, p and q the two smoothed rates divided by their integrals, 0 ... 1. Exactly 0
  /// where the rates differ by one factor; NaN where nothing wears.
  double elsewhere;
};

/// Half of int |p - q| ds over two rates by bin, each divided by its integral, 0 ... 1; NaN where
/// one of them is zero everywhere.
[[nodiscard]] double share_elsewhere(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                                     const Eigen::VectorXd& widths);

/// `other` is the campaign's case with another law, `recorded` on `dem_liner` as in load.h5.
[[nodiscard]] LawOnLoad law_on_load(const Case& campaign, const Case& other,
                                    const LinerProfile& dem_liner, const WallLoad& recorded);

/// One cycle of a campaign under another law. The times are of the steps that the cycle took, and
/// NaN where its wear is not done yet.
struct LawOnCycle {
  int cycle;
  double lifter_height;  ///< of the liner that the load was measured on [m]
  LawOnLoad law;
  double campaign_hours;  ///< in the campaign [h]
  double hours;           ///< campaign_hours x campaign_rate / section_rate [h]
};

struct ReappliedLaw {
  Case campaign;  ///< as it was run
  Case other;     ///< the same with the law that is put to its loads
  std::vector<LawOnCycle> cycles;
  bool life_reached;      ///< whether the campaign wore its liner out
  double lifter_height;   ///< of the last liner [m]
  double campaign_hours;  ///< to that liner [h]
  double hours;           ///< to that liner under the other law [h]
  double elsewhere;       ///< the largest of the cycles whose wear is done; NaN for none
};

/// The steel between the liners of a finished or unfinished campaign at the rates of another law,
/// from the loads that its folder keeps. Exact where the rates differ by one factor. Else the
/// liners would have taken other shapes, and loads, and it is an approximation: `elsewhere`.
///
/// Nothing is written. Throws Failure (usage) where the folder has no campaign or no load yet,
/// InputError where `mill` differs from the campaign's case in more than its law and [campaign],
/// ResultRejected where a kept file is not as it was published.
[[nodiscard]] ReappliedLaw reapply(const Case& mill, const RunFolder& folder);

/// Depth rate of every bin by every mechanism of the law, in all cycles that have a load.
[[nodiscard]] std::vector<WearRateRow> wear_rates(const ReappliedLaw& law, const RunFolder& folder);

}  // namespace millwear::orchestrator
