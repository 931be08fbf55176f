#include "orchestrator/campaign/open_campaign.h"

#include <fmt/format.h>

#include <utility>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/lowered_limits.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Of all that a result depends on.
std::string hash_of_case(Case mill) {
  mill.dem.launcher = DemSettings{}.launcher;
  return hash_of_text(locked_case_text(mill));
}

void check_same_case(const Case& mill, const Ledger& ledger, const RunFolder& folder) {
  if (ledger.start.case_hash == hash_of_case(mill)) return;
  throw InputError(fmt::format(
      "{}: the case differs from the one that {} was begun with ({} has that one in full); "
      "`millwear run` goes on where only limits are lower; give another folder with --out, or "
      "move this one away",
      mill.file.string(), folder.root.string(), folder.locked_case().string()));
}

bool lowers_limits_of(const Case& mill, const Ledger& ledger, const RunFolder& folder) {
  return ledger.start.case_hash != hash_of_case(mill) && fs::exists(folder.locked_case()) &&
         only_lowers_limits(mill, read_case(folder.locked_case()));
}

/// Throws ResultRejected unless the loads and steps are those that the ledger has.
void check_loads_and_steps(Ledger ledger, const RunFolder& folder) {
  for (auto& entry : ledger.entries)
    std::erase_if(entry.outputs, [](const auto& output) {
      return output.first != stage_files::load && output.first != stage_files::steps;
    });
  check_outputs(ledger, folder.root);
}

fs::path tables_in(const RunFolder& folder) {
  return fs::exists(folder.results() / "history.csv") ? folder.results() : folder.root;
}

}  // namespace

RunFolder run_folder_of(const Case& mill, const fs::path& out) {
  return {out.empty() ? fs::path("runs") / mill.name : out};
}

fs::path folder_of_charge(const Case& mill) {
  return fs::weakly_canonical(fs::absolute(mill.file).parent_path() / *mill.dem.charge_from);
}

Case as_kept(Case mill, const RunFolder& folder) {
  auto& charge_from = mill.dem.charge_from;
  if (charge_from && charge_from->is_relative())
    charge_from =
        folder_of_charge(mill).lexically_relative(fs::weakly_canonical(fs::absolute(folder.root)));
  return mill;
}

OpenCampaign campaign_to_run(const Case& described, const RunFolder& folder,
                             const CampaignStarter& starter, std::optional<int> asked_ranks) {
  const Case mill = as_kept(described, folder);
  auto ledger = read_ledger(folder.ledger());
  if (!ledger || ledger->entries.empty())
    return {{mill, folder, starter.ranks},
            {{starter.program, hash_of_case(mill), starter.ranks, starter.host}, {}}};
  if (lowers_limits_of(mill, *ledger, folder))
    ledger = reopened(std::move(*ledger), hash_of_case(mill));
  check_same_case(mill, *ledger, folder);
  const int ranks = ledger->start.ranks;
  if (asked_ranks && *asked_ranks != ranks)
    throw Failure(ExitCode::usage,
                  fmt::format("{} was begun with {} ranks and goes on with the same; leave --ranks "
                              "out, or run into another folder with --out",
                              folder.root.string(), ranks));
  check_outputs(*ledger, folder.root);
  return {{mill, folder, ranks}, std::move(*ledger)};
}

void keep_start(const OpenCampaign& opened) {
  const RunFolder& folder = opened.campaign.folder;
  const auto kept = read_ledger(folder.ledger());
  const bool is_going_on = kept && !opened.ledger.entries.empty() &&
                           kept->start.case_hash == opened.ledger.start.case_hash;
  if (is_going_on) return;
  publish(folder.locked_case(), locked_case_text(opened.campaign.mill));
  write_ledger(folder.ledger(), opened.ledger);
}

OpenCampaign campaign_of(const Case& described, const RunFolder& folder) {
  const Case mill = as_kept(described, folder);
  auto ledger = read_ledger(folder.ledger());
  if (!ledger)
    throw Failure(ExitCode::usage,
                  fmt::format("{}: no campaign is here; start one with `millwear run {}`",
                              folder.root.string(), mill.file.string()));
  check_same_case(mill, *ledger, folder);
  return {{mill, folder, ledger->start.ranks}, std::move(*ledger)};
}

OpenCampaign campaign_with_loads(const RunFolder& folder) {
  auto ledger = read_ledger(folder.ledger());
  if (!ledger || !fs::exists(folder.locked_case()))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: no campaign is here; name one that `millwear run` has worked "
                              "in with --out",
                              folder.root.string()));
  if (ledger->find({0, StageKind::dem}) == nullptr)
    throw Failure(ExitCode::usage, fmt::format("{}: the campaign has no load yet (its first is "
                                               "measured in cycle 0 dem); let `millwear run` go "
                                               "on until then",
                                               folder.root.string()));
  const Case run = read_case(folder.locked_case());
  check_loads_and_steps(*ledger, folder);
  return {{run, folder, ledger->start.ranks}, std::move(*ledger)};
}

std::optional<OpenCampaign> campaign_up_to_mixing(const RunFolder& folder) {
  const auto ledger = read_ledger(folder.ledger());
  if (!ledger || ledger->find({0, StageKind::mix}) == nullptr) return std::nullopt;
  Ledger part{ledger->start, {}};
  for (const StageKind kind : {StageKind::mesh, StageKind::mix})
    if (const auto* const entry = ledger->find({0, kind})) part.entries.push_back(*entry);
  return OpenCampaign{{read_case(folder.locked_case()), folder, ledger->start.ranks},
                      std::move(part)};
}

fs::path results_of(const Case& mill, const RunFolder& folder) {
  const fs::path tables = tables_in(folder);
  if (!fs::exists(folder.locked_case()) || !fs::exists(tables / "history.csv"))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: no campaign with results is here; `millwear run {}` makes one, "
                              "or name its folder with --out",
                              folder.root.string(), mill.file.string()));
  const LinerProfile liner = read_case(folder.locked_case()).liner;
  const auto& sector = mill.liner.sector;
  if (liner.nodes != mill.liner.nodes || liner.sector.rows != sector.rows ||
      liner.sector.shell_radius != sector.shell_radius ||
      liner.sector.plate_radius != sector.plate_radius)
    throw InputError(fmt::format(
        "{}: its new liner is not that of the campaign in {} ({} has that one in full); name the "
        "campaign's folder with --out",
        mill.file.string(), folder.root.string(), folder.locked_case().string()));
  return tables;
}

}  // namespace millwear::orchestrator
