#pragma once
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/loads/cycle_load.h"
#include "orchestrator/results/campaign_results.h"
#include "wear/band/liner_replicates.h"

namespace millwear::orchestrator {

/// Where a campaign stands between two cycles.
struct CampaignMoment {
  double time;         ///< milled since the liner was new [s]
  double hours;        ///< likewise, as `history.csv` sums them [h]
  LinerProfile liner;  ///< in the steel's frame
  /// Hours at which each change of operation began [h]; NaN, or missing, where it has not.
  std::vector<double> begun_hours{};
};

/// What one cycle adds to a campaign's results, besides what `CycleLoad` tells.
struct CycleResults {
  double load_time;                 ///< when the load was measured [s]
  Rotation rotation;                ///< which way the mill turned
  bool continues;                   ///< operated the same way as in the cycle before
  std::vector<HistoryRow> history;  ///< in cycle 0 with the new liner
  std::vector<ProfileRow> profiles;
  std::vector<ReplicateRow> replicates;
  std::vector<double> step_durations;  ///< [s]
  Conservation conservation;
  PowerSeries power;
  wear::MotionMeasures motion;
  std::optional<std::string> warning;  ///< of the charge that the cycle began with
  wear::LinerReplicates liners_after;  ///< as the DEM turns them
  CampaignMoment after;
};

/// The loads of every cycle whose wear is published, in order.
[[nodiscard]] std::vector<CycleLoad> loads_of_cycles(const Campaign& campaign,
                                                     const Ledger& ledger);

/// The results of every cycle whose wear is published, in order; `loads` are those of the same
/// cycles. A cycle's are kept once no later cycle can change them (its band looks three loads
/// ahead), so that a campaign's next cycle works out only what is new.
[[nodiscard]] std::vector<CycleResults> results_of_cycles(const Campaign& campaign,
                                                          const Ledger& ledger,
                                                          const std::vector<CycleLoad>& loads);

}  // namespace millwear::orchestrator
