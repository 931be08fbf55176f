#include "orchestrator/dem_run/cost_estimate.h"

#include <algorithm>

#include "liggghts_inputs/decks/chunks.h"
#include "orchestrator/dem_run/rank_cost.h"
#include "orchestrator/process/usable_cores.h"

namespace millwear::orchestrator {

int ranks_for(const Case& mill) { return mill.dem.ranks > 0 ? mill.dem.ranks : usable_cores(); }

CostEstimate estimate_cost(const Case& mill, int ranks) {
  const auto plan = plan_steps(mill);
  const double seconds_per_step = rank_cost(mill, ranks).step_seconds;
  const auto mixing = liggghts::mixing_steps(mill, plan);
  const auto measuring = liggghts::measuring_steps(mill, plan);
  long longest = 0;
  for (const auto& stretch : {mixing, measuring})
    for (const auto& chunk : liggghts::chunks_of(mill, stretch, plan))
      longest = std::max(longest, chunk.steps.total());
  return {seconds_per_step * static_cast<double>(mixing.total()),
          seconds_per_step * static_cast<double>(measuring.total()),
          seconds_per_step * static_cast<double>(measuring.most_total()),
          seconds_per_step * static_cast<double>(longest)};
}

double campaign_seconds(const Case& mill, const CostEstimate& cost) {
  constexpr int usual_loads = 12;
  return cost.mixing + cost.per_cycle_most * std::min(usual_loads, mill.campaign.cycle_limit);
}

}  // namespace millwear::orchestrator
