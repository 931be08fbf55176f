#include "orchestrator/calibration/campaign_path.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "wear/rate/load_rate.h"
#include "wear/record/load_read.h"

namespace millwear::orchestrator {
namespace {

std::vector<wear::PathStep> steps_of(const OpenCampaign& kept, int cycle) {
  const StageId worn{cycle, StageKind::wear};
  if (kept.ledger.find(worn) == nullptr) return {};
  const auto read = read_cycle(kept.campaign.folder.stage(worn) / stage_files::steps,
                               kept.campaign.mill.liner.sector);
  std::vector<wear::PathStep> steps;
  for (const auto& step : read.steps)
    if (step.accounted_area > 0.0) steps.push_back({step.accounted_area, step.profile});
  return steps;
}

/// The smoothed rate of a load, along the liner in the steel's frame.
wear::ArcCurve rate_along_steel(const Case& mill, const LinerProfile& dem_liner,
                                const WallLoad& recorded, Rotation rotation) {
  return as_turned(
      wear::rate_of_load(mill.wear, mill.charge.classes, dem_liner, recorded).smoothed.rate,
      rotation);
}

}  // namespace

std::vector<wear::PathCycle> path_cycles(const OpenCampaign& kept, const Case& other) {
  const Campaign& campaign = kept.campaign;
  std::vector<wear::PathCycle> cycles;
  for (int cycle = 0; kept.ledger.find({cycle, StageKind::dem}) != nullptr; ++cycle) {
    const auto recorded =
        wear::read_load(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load);
    const Rotation rotation = rotation_of_cycle(campaign, cycle);
    const LinerProfile dem_liner = dem_liner_of_cycle(campaign, cycle);
    cycles.push_back({liner_of_cycle(campaign, cycle),
                      rate_along_steel(campaign.mill, dem_liner, recorded, rotation),
                      {},
                      steps_of(kept, cycle)});
    for (const auto& mechanism : other.wear.mechanisms) {
      Case alone = other;
      alone.wear.mechanisms = {mechanism};
      cycles.back().mechanisms.push_back(rate_along_steel(alone, dem_liner, recorded, rotation));
    }
  }
  if (cycles.front().steps.empty())
    throw Failure(
        ExitCode::usage,
        fmt::format("{}: no wear of the campaign is done yet (its first is cycle 0 wear); "
                    "let `millwear run` go on until it has worn the liner as far as the "
                    "readings",
                    campaign.folder.root.string()));
  return cycles;
}

}  // namespace millwear::orchestrator
