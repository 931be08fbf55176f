#include "orchestrator/export/published_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/case/operated_mill.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/loads/cycle_load.h"
#include "wear/charge/charge_record.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// A file that a cycle's DEM published and that is here, as the ledger has it.
std::optional<fs::path> published_file(const PublishedCampaign& published, int cycle,
                                       const char* name) {
  const StageId dem{cycle, StageKind::dem};
  const auto* const entry = published.ledger ? published.ledger->find(dem) : nullptr;
  const RunFolder& folder = published.campaign.folder;
  const fs::path file = folder.stage(dem) / name;
  if (entry == nullptr || !entry->outputs.contains(name) || !fs::exists(file)) return std::nullopt;
  check_outputs({{}, {{dem, entry->outcome, {{name, entry->outputs.at(name)}}, 0.0}}}, folder.root);
  return file;
}

/// "cycle 3 has steps 1 to 7"
std::string spoken_steps(const std::vector<ProfileRow>& profiles, int cycle) {
  int first = -1;
  int last = -1;
  for (const auto& row : profiles) {
    if (row.cycle != cycle) continue;
    if (first < 0) first = row.step;
    last = row.step;
  }
  return first == last ? fmt::format("cycle {} has step {} alone", cycle, first)
                       : fmt::format("cycle {} has steps {} to {}", cycle, first, last);
}

}  // namespace

PublishedCampaign published_campaign(const Case& mill, const RunFolder& folder) {
  const fs::path tables = results_of(mill, folder);
  // A cycle begins once the tables have the cycle before: those that are read after the ledger do.
  auto ledger = read_ledger(folder.ledger());
  auto profiles = read_profiles_csv(tables / "profiles.csv");
  if (profiles.empty())
    throw ResultRejected(fmt::format("{}: it has no profile; `millwear report` writes it again",
                                     (tables / "profiles.csv").string()));
  const int ranks = ledger ? ledger->start.ranks : 1;
  return {{read_case(folder.locked_case()), folder, ranks}, std::move(ledger), std::move(profiles)};
}

const ProfileRow& profile_after(const PublishedCampaign& published, std::optional<int> cycle,
                                std::optional<int> step) {
  const auto& profiles = published.profiles;
  const int last_cycle = profiles.back().cycle;
  const int of = cycle.value_or(last_cycle);
  const auto in_cycle = [&](const ProfileRow& row) { return row.cycle == of; };
  if (std::ranges::none_of(profiles, in_cycle))
    throw Failure(
        ExitCode::usage,
        fmt::format("--cycle {}: {} has no profile of this cycle; there are cycles 0 to {}", of,
                    published.campaign.folder.root.string(), last_cycle));
  const auto found = std::find_if(profiles.rbegin(), profiles.rend(), [&](const auto& row) {
    return in_cycle(row) && row.step == step.value_or(row.step);
  });
  if (found == profiles.rend())
    throw Failure(ExitCode::usage,
                  fmt::format("--at-step {}: {} has no such step; {}", *step,
                              published.campaign.folder.root.string(), spoken_steps(profiles, of)));
  return *found;
}

int cycles_begun(const PublishedCampaign& published) { return published.profiles.back().cycle + 2; }

const ProfileRow& profile_before(const PublishedCampaign& published, int cycle) {
  const ProfileRow* before = &published.profiles.front();
  for (const auto& row : published.profiles)
    if (row.cycle < cycle) before = &row;
  return *before;
}

CycleStart start_of(const PublishedCampaign& published, int cycle) {
  const auto& mill = published.campaign.mill;
  const ProfileRow& before = profile_before(published, cycle);
  const double hours = before.operating_hours;
  const LinerProfile liner{mill.liner.sector, before.nodes};
  return {hours, liner,
          rotation_at(mill.campaign, {hours * seconds_per_hour, lifter_height(liner)})};
}

std::optional<LoadAlongProfile> load_of(const PublishedCampaign& published, int cycle) {
  if (!published_file(published, cycle, stage_files::load)) return std::nullopt;
  const auto& hash = published.ledger->find({cycle, StageKind::dem})->outputs.at(stage_files::load);
  return look_at_load_of_cycle(published.campaign, cycle, hash).along;
}

std::optional<wear::ChargeFrames> frames_of(const PublishedCampaign& published, int cycle) {
  const auto file = published_file(published, cycle, stage_files::charge);
  return file ? wear::read_charge(*file).frames : std::nullopt;
}

}  // namespace millwear::orchestrator
