#pragma once
#include <functional>
#include <optional>
#include <string>

#include "mill/case/case.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// What a campaign does next, and why.
struct NextStage {
  StageId stage;
  std::string why;
};

/// Whether a campaign chooses its neighbour skin and how the ranks share the mill by a trial.
enum class SpeedTrial { none, after_first_mix };

/// What the case says of the order of stages.
struct CampaignPlan {
  int cycle_limit;
  SpeedTrial trial = SpeedTrial::none;
  std::optional<StageId> until{};  ///< run no further than this stage
};

[[nodiscard]] CampaignPlan plan_of(const Case& mill);

/// The first stage of the campaign that the ledger does not have; std::nullopt once a cycle has
/// reached a limit or `cycle_limit` cycles are done. Each cycle goes mesh, dem, wear, with mix
/// before the first dem and before the first after a reversal or a change of operation
/// (`begins_anew`). A trial of speed comes once, after the first mix.
[[nodiscard]] std::optional<NextStage> next_stage(const Ledger& ledger, const CampaignPlan& plan);

/// How the campaign stands: the limit it ended at, or go_on.
[[nodiscard]] Outcome outcome_of(const Ledger& ledger);

/// What the campaign does to the world; tests put a fake in its place.
struct CampaignEffects {
  std::function<LedgerEntry(const StageId&)> run_stage;  ///< runs and publishes a stage
  std::function<void(const LedgerEntry&)> record;        ///< appends to the ledger on disk
  std::function<void(const Ledger&)> after_cycle;        ///< results so far
};

/// Runs stage after stage until there is none left, or `plan.until` is published; returns the
/// finished ledger. Whatever an effect throws leaves every published stage in the ledger, and a
/// later call goes on from there.
Ledger run_campaign(Ledger ledger, const CampaignPlan& plan, const CampaignEffects& effects);

}  // namespace millwear::orchestrator
