#include "orchestrator/dem_run/rank_cost.h"

#include <algorithm>
#include <cmath>

#include "liggghts_inputs/decks/deck.h"

namespace millwear::orchestrator {
namespace {

/// Of a particle and step [s], where the particles of a rank fit into the processor's caches and
/// where they do not; between them linear in the logarithm of their number.
constexpr double cached_particles = 1.2e3;
constexpr double cached_seconds = 0.26e-6;
constexpr double uncached_particles = 2.0e4;
constexpr double uncached_seconds = 0.40e-6;
/// Of a ghost, as a share of that.
constexpr double ghost_share = 0.25;
/// Of the messages of a step [s].
constexpr double message_seconds = 100e-6;
/// Width of the moving charge over the mill's.
constexpr double charge_width = 0.7;
/// Particles of the rank that has most, over the mean, between two cuts.
constexpr double usual_imbalance = 1.02;
constexpr double bytes_of_rank = 60.0 * (1 << 20);
constexpr double bytes_of_particle = 1500.0;

double particle_seconds(double particles) {
  const double share =
      std::log(particles / cached_particles) / std::log(uncached_particles / cached_particles);
  return cached_seconds + (uncached_seconds - cached_seconds) * std::clamp(share, 0.0, 1.0);
}

}  // namespace

RankCost rank_cost(const Case& mill, int ranks) {
  RankCost cost{};
  cost.ranks = ranks;
  cost.columns = liggghts::rank_columns(mill, ranks);
  cost.slabs = ranks / cost.columns;
  const double reach = largest_diameter(mill);
  const double width = charge_width * 2.0 * mill.liner.sector.plate_radius;
  cost.particles = static_cast<double>(totals(mill).particles) / ranks;
  cost.ghosts = (1.0 + 2.0 * (cost.columns - 1) * reach / width) *
                    (1.0 + 2.0 * reach * cost.slabs / mill.slice_length) -
                1.0;
  cost.imbalance = cost.columns > 1 ? usual_imbalance : 1.0;
  const double all = cost.particles * (1.0 + cost.ghosts);
  cost.step_seconds =
      cost.imbalance * cost.particles * particle_seconds(all) * (1.0 + ghost_share * cost.ghosts) +
      (ranks > 1 ? message_seconds : 0.0);
  cost.memory = ranks * (bytes_of_rank + bytes_of_particle * all);
  return cost;
}

}  // namespace millwear::orchestrator
