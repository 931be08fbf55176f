#include "orchestrator/stages/wear_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mill/case/operated_mill.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/loads/cycle_load.h"
#include "wear/evolve/evolution.h"

namespace millwear::orchestrator {
namespace {

/// How the steps from one moment to another leave the campaign. `limits` are those that the steps
/// ended at: the height may be one at which the operation changes.
Outcome outcome_of_steps(wear::EvolutionEnd end, const CampaignSettings& plan,
                         const CampaignSettings& limits, const LinerMoment& first,
                         const LinerMoment& last) {
  if (end == wear::EvolutionEnd::plate_limit) return Outcome::plate_limit;
  if (end == wear::EvolutionEnd::height_limit && limits.height_limit <= plan.height_limit)
    return Outcome::height_limit;
  if (operation_in_force(plan, first) == operation_in_force(plan, last)) return Outcome::go_on;
  return rotation_at(plan, first) == rotation_at(plan, last) ? Outcome::changed : Outcome::reversed;
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
          : std::max(first_cycle_of_operation(campaign, cycle), cycle + 1 - loads_that_count);
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
  const auto& plan = mill.campaign;
  const LinerMoment first = moment_before(campaign, cycle);
  const Rotation rotation = rotation_at(plan, first);
  const LoadRange range = range_of_load(plan, first);
  CampaignSettings limits = plan;
  limits.height_limit = std::max(plan.height_limit, range.height);
  const auto evolution = wear::evolve(loads.timed, lifter_area(mill.liner), limits, range.time);
  LinerMoment last = first;
  KeptCycle kept{loads.newest.smoothed.moved_share, loads.newest.worn_by_load, {}};
  for (const auto& step : evolution.steps) {
    kept.steps.push_back({step.duration, step.removed_area, step.accounted_area, step.fallen_area,
                          as_turned(step.profile, rotation)});
    last = {last.time + step.duration, lifter_height(step.profile)};
  }
  write_cycle(into / stage_files::steps, kept);
  return outcome_of_steps(evolution.end, plan, limits, first, last);
}

}  // namespace millwear::orchestrator
