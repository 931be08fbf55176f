#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/results/campaign_results.h"
#include "orchestrator/results/cycle_results.h"

namespace millwear::orchestrator {

/// Lives of the replicates [h], see `wear::lives`: where the campaign is not at its end, as if no
/// later load had noise. Empty without a cycle.
[[nodiscard]] Eigen::VectorXd lives_of(const Case& mill, const std::vector<CycleResults>& cycles);

/// How well a campaign knows its life after some of its loads.
struct LifeErrorSoFar {
  double relative_error;  ///< standard error of the life over the life, by the loads so far
  double share_of_life;   ///< of the liner that is gone, above 0, up to 1
};

/// How many times as long as the loads so far the next ones are to be measured for the 95 % band
/// of the life to end `target` times the life from it; infinite where the loads so far are too
/// noisy for that. n loads with a variance of v each have worn a share s, (1 - s) / s times as many
/// are to come, and one measured k times as long makes v / k.
[[nodiscard]] double length_ratio(const LifeErrorSoFar& so_far, double target);

/// Revolutions over which the next load of a campaign is to be measured: from `measure_revolutions`
/// to four times that. Without a target, and for the first load, of which nothing is known yet, the
/// least.
[[nodiscard]] double revolutions_of_next_load(const Campaign& campaign, const Ledger& ledger);

/// That the life is not known as well as the case wants, once it is reached.
[[nodiscard]] std::optional<std::string> life_error_warning(const Case& mill, const Life& life);

}  // namespace millwear::orchestrator
