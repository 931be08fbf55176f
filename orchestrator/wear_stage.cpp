#include <fmt/format.h>

#include <stdexcept>

#include "orchestrator/stages.h"
#include "wear/evolution.h"
#include "wear/load_rate.h"
#include "wear/load_store.h"

namespace millwear::orchestrator {
namespace {

Outcome outcome_from_end(wear::EvolutionEnd end) {
  switch (end) {
    case wear::EvolutionEnd::threshold_reached:
      return Outcome::go_on;
    case wear::EvolutionEnd::height_limit:
      return Outcome::height_limit;
    case wear::EvolutionEnd::plate_limit:
      return Outcome::plate_limit;
  }
  throw std::logic_error("an end of no kind");
}

}  // namespace

Outcome wear_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into) {
  const auto& mill = campaign.mill;
  const auto recorded =
      wear::read_load(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load);
  const auto rate = wear::rate_of_load(mill, recorded);
  const auto evolution = wear::evolve(liner_of_cycle(campaign, cycle), rate.smoothed.rate,
                                      lifter_area(mill.liner), mill.campaign);
  KeptCycle kept{rate.smoothed.moved_share, rate.raw.dot(rate.load.bin_widths()), {}};
  for (const auto& step : evolution.steps)
    kept.steps.push_back(
        {step.duration, step.removed_area, step.accounted_area, step.fallen_area, step.profile});
  write_cycle(into / stage_files::steps, kept);
  return outcome_from_end(evolution.end);
}

}  // namespace millwear::orchestrator
