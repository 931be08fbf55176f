#include "orchestrator/campaign/stage_order.h"

#include <fmt/format.h>

namespace millwear::orchestrator {
namespace {

std::vector<StageKind> stages_of(int cycle, SpeedTrial trial, const Ledger& ledger) {
  if (cycle == 0 && trial == SpeedTrial::after_first_mix)
    return {StageKind::mesh, StageKind::mix, StageKind::tune, StageKind::dem, StageKind::wear};
  const LedgerEntry* const before = ledger.find({cycle - 1, StageKind::wear});
  if (cycle == 0 || (before != nullptr && begins_anew(before->outcome)))
    return {StageKind::mesh, StageKind::mix, StageKind::dem, StageKind::wear};
  return {StageKind::mesh, StageKind::dem, StageKind::wear};
}

std::string reason_for(const StageId& stage, const Ledger& ledger) {
  if (ledger.entries.empty()) return "the campaign is new";
  const auto& last = ledger.entries.back();
  if (last.outcome == Outcome::reversed)
    return fmt::format("the mill was reversed after {}", name_of(last.stage));
  if (last.outcome == Outcome::changed)
    return fmt::format("the operation changed after {}", name_of(last.stage));
  if (stage.kind == StageKind::mesh)
    return fmt::format("{} left the liner above its limits", name_of(last.stage));
  return fmt::format("{} is published and this is not", name_of(last.stage));
}

}  // namespace

CampaignPlan plan_of(const Case& mill) {
  return {mill.campaign.cycle_limit,
          mill.dem.tune ? SpeedTrial::after_first_mix : SpeedTrial::none};
}

Outcome outcome_of(const Ledger& ledger) {
  const auto last = ledger.entries.empty() ? Outcome::go_on : ledger.entries.back().outcome;
  return begins_anew(last) ? Outcome::go_on : last;
}

std::optional<NextStage> next_stage(const Ledger& ledger, const CampaignPlan& plan) {
  if (outcome_of(ledger) != Outcome::go_on) return std::nullopt;
  for (int cycle = 0; cycle < plan.cycle_limit; ++cycle)
    for (const StageKind kind : stages_of(cycle, plan.trial, ledger)) {
      const StageId stage{cycle, kind};
      if (ledger.find(stage) == nullptr) return NextStage{stage, reason_for(stage, ledger)};
    }
  return std::nullopt;
}

Ledger run_campaign(Ledger ledger, const CampaignPlan& plan, const CampaignEffects& effects) {
  while (const auto next = next_stage(ledger, plan)) {
    if (plan.until && ledger.find(*plan.until) != nullptr) break;
    const LedgerEntry entry = effects.run_stage(next->stage);
    effects.record(entry);
    ledger.entries.push_back(entry);
    if (next->stage.kind == StageKind::wear) effects.after_cycle(ledger);
  }
  return ledger;
}

}  // namespace millwear::orchestrator
