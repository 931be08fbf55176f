#include "orchestrator/dem_run/cost_estimate.h"

#include "liggghts_inputs/decks/stretch.h"
#include "orchestrator/process/usable_cores.h"

namespace millwear::orchestrator {

int ranks_for(const Case& mill) { return mill.dem.ranks > 0 ? mill.dem.ranks : usable_cores(); }

CostEstimate estimate_cost(const Case& mill, int ranks) {
  const auto plan = plan_steps(mill);
  const double seconds_per_step =
      static_cast<double>(totals(mill).particles) / (particle_steps_per_second * ranks);
  const auto mixing = liggghts::mixing_steps(mill, plan);
  const auto measuring = liggghts::measuring_steps(mill, plan);
  return {seconds_per_step * static_cast<double>(mixing.total()),
          seconds_per_step * static_cast<double>(measuring.total()),
          seconds_per_step * static_cast<double>(measuring.most_total())};
}

}  // namespace millwear::orchestrator
