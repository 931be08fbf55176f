#include "orchestrator/stages/wear_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/loads/cycle_load.h"
#include "wear/evolve/evolution.h"

namespace millwear::orchestrator {
namespace {

/// `is_reversed`: the steps led to a reversal of the rotation.
Outcome outcome_from_end(wear::EvolutionEnd end, bool is_reversed) {
  switch (end) {
    case wear::EvolutionEnd::load_spent:
    case wear::EvolutionEnd::time_reached:
      return is_reversed ? Outcome::reversed : Outcome::go_on;
    case wear::EvolutionEnd::height_limit:
      return Outcome::height_limit;
    case wear::EvolutionEnd::plate_limit:
      return Outcome::plate_limit;
  }
  throw std::logic_error("an end of no kind");
}

constexpr int loads_that_count = 3;

/// The loads of a cycle and of those before it that its wear depends on, and the newest alone.
struct LoadsOfCycle {
  std::vector<wear::TimedLoad> timed;
  CycleLoad newest;
};

LoadsOfCycle loads_of_cycle(const Campaign& campaign, int cycle) {
  const int first =
      campaign.mill.campaign.scheme == Scheme::threshold
          ? cycle
          : std::max(first_cycle_of_rotation(campaign, cycle), cycle + 1 - loads_that_count);
  std::vector<wear::TimedLoad> timed;
  for (int i = first;; ++i) {
    CycleLoad load = load_of_cycle(campaign, i);
    timed.push_back(
        timed_load(milling_time_before(campaign, i), dem_liner_of_cycle(campaign, i), load));
    if (i == cycle) return {std::move(timed), std::move(load)};
  }
}

}  // namespace

Outcome wear_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into) {
  const auto& mill = campaign.mill;
  const LoadsOfCycle loads = loads_of_cycle(campaign, cycle);
  const auto& reversals = mill.campaign.reversal_times;
  const double begin = milling_time_before(campaign, cycle);
  const Rotation rotation = rotation_after(reversals, begin);
  const auto evolution = wear::evolve(
      loads.timed, lifter_area(mill.liner), mill.campaign,
      time_to_reversal(reversals, begin).value_or(std::numeric_limits<double>::infinity()));
  double end = begin;
  KeptCycle kept{loads.newest.smoothed.moved_share, loads.newest.worn_by_load, {}};
  for (const auto& step : evolution.steps) {
    kept.steps.push_back({step.duration, step.removed_area, step.accounted_area, step.fallen_area,
                          as_turned(step.profile, rotation)});
    end += step.duration;
  }
  write_cycle(into / stage_files::steps, kept);
  return outcome_from_end(evolution.end,
                          reversals_by(reversals, end) > reversals_by(reversals, begin));
}

}  // namespace millwear::orchestrator
