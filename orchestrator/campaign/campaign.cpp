#include "orchestrator/campaign/campaign.h"

#include <algorithm>

#include "mill/case/operated_mill.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"

namespace millwear::orchestrator {
namespace {

/// Whether the mill is operated the same way all the time.
bool is_constant(const CampaignSettings& plan) {
  return plan.reversal_times.empty() && plan.operation.empty();
}

}  // namespace

LinerProfile liner_of_cycle(const Campaign& campaign, int cycle) {
  if (cycle == 0) return campaign.mill.liner;
  const auto folder = campaign.folder.stage({cycle - 1, StageKind::wear});
  const auto kept = read_cycle(folder / stage_files::steps, campaign.mill.liner.sector);
  const bool was_worn_out_before = kept.steps.empty();
  return was_worn_out_before ? liner_of_cycle(campaign, cycle - 1) : kept.steps.back().profile;
}

Rotation rotation_of_cycle(const Campaign& campaign, int cycle) {
  const auto& plan = campaign.mill.campaign;
  return is_constant(plan) ? Rotation::as_new : rotation_at(plan, moment_before(campaign, cycle));
}

LinerProfile dem_liner_of_cycle(const Campaign& campaign, int cycle) {
  return as_turned(liner_of_cycle(campaign, cycle), rotation_of_cycle(campaign, cycle));
}

int first_cycle_of_operation(const Campaign& campaign, int cycle) {
  const auto& plan = campaign.mill.campaign;
  if (is_constant(plan)) return 0;
  const auto in_force = [&](int of) {
    return operation_in_force(plan, moment_before(campaign, of));
  };
  int first = cycle;
  while (first > 0 && in_force(first - 1) == in_force(cycle)) --first;
  return first;
}

Campaign as_operated(const Campaign& campaign, int cycle) {
  Campaign operated = campaign;
  const auto& changes = campaign.mill.campaign.operation;
  if (!changes.empty())
    operated.mill =
        as_operated(campaign.mill, changes_begun(changes, moment_before(campaign, cycle)));
  return operated;
}

LinerMoment moment_before(const Campaign& campaign, int cycle) {
  return {milling_time_before(campaign, cycle), lifter_height(liner_of_cycle(campaign, cycle))};
}

double milling_time_before(const Campaign& campaign, int cycle) {
  double time = 0.0;
  for (int i = 0; i < cycle; ++i) {
    const auto folder = campaign.folder.stage({i, StageKind::wear});
    for (const auto& step :
         read_cycle(folder / stage_files::steps, campaign.mill.liner.sector).steps)
      time += step.duration;
  }
  return time;
}

double share_of_life(const Case& mill, const LinerProfile& liner) {
  const auto gone = [](double now, double fresh, double limit) {
    return fresh > limit ? (fresh - now) / (fresh - limit) : 1.0;
  };
  return std::clamp(
      std::max(
          gone(lifter_height(liner), lifter_height(mill.liner), mill.campaign.height_limit),
          gone(plate_thickness(liner), plate_thickness(mill.liner), mill.campaign.plate_limit)),
      0.0, 1.0);
}

}  // namespace millwear::orchestrator
