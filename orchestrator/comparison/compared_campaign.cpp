#include "orchestrator/comparison/compared_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/comparison/published_life.h"
#include "orchestrator/comparison/shown_cycles.h"
#include "orchestrator/export/published_campaign.h"
#include "orchestrator/pictures/charge_pictures.h"
#include "orchestrator/results/history.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

// So that a page of four campaigns stays below 12 MB.
constexpr std::size_t most_loads = 12;
constexpr std::size_t most_charges = 8;
const std::set<std::string> shown_pictures{"section", "close_up"};

/// The liners that these cycles began with, and the last.
std::vector<ProfileRow> profiles_of(const PublishedCampaign& published,
                                    const std::vector<int>& cycles) {
  std::vector<ProfileRow> profiles;
  const auto add = [&](const ProfileRow& row) {
    if (profiles.empty() || profiles.back().operating_hours < row.operating_hours)
      profiles.push_back({row.cycle, row.step, row.operating_hours, row.nodes, {}});
  };
  for (const int cycle : cycles) add(profile_before(published, cycle));
  add(published.profiles.back());
  return profiles;
}

/// The smoothed lines of a load alone, of what the page draws: all of them would double the page.
LoadAlongProfile smoothed_alone(LoadAlongProfile load) {
  load.contacts = {};
  for (LoadLine* line : {&load.normal_dissipation, &load.sliding_work, &load.depth_rate}) {
    line->raw.clear();
    line->standard_error.clear();
  }
  return load;
}

std::vector<LoadAlongProfile> loads_of(const PublishedCampaign& published,
                                       const std::vector<int>& cycles) {
  std::vector<LoadAlongProfile> loads;
  for (const int cycle : cycles) {
    auto load = load_of(published, cycle);
    if (!load) continue;
    const CycleStart start = start_of(published, cycle);
    load->centres = bin_places(start.liner, start.rotation, load->arc_length);
    loads.push_back(smoothed_alone(std::move(*load)));
  }
  return loads;
}

/// The charge, with frames and pictures of the first and the last cycle that recorded it.
ShownCharge charge_of(const PublishedCampaign& published, const std::vector<int>& cycles) {
  ShownCharge charge = charge_of_cycles(published.campaign, cycles);
  if (published.ledger) add_kept_pictures(published.campaign, *published.ledger, charge);
  for (auto& one : charge.cycles) {
    const bool is_between = &one != &charge.cycles.front() && &one != &charge.cycles.back();
    if (is_between) one.frames.reset();
    std::erase_if(one.pictures, [&](const auto& named) {
      return is_between || !shown_pictures.contains(named.first);
    });
  }
  return charge;
}

/// The cycles that have a file of the DEM.
std::vector<int> with_file(const RunFolder& folder, const std::vector<int>& cycles,
                           const char* file) {
  std::vector<int> found;
  for (const int cycle : cycles)
    if (fs::exists(folder.stage({cycle, StageKind::dem}) / file)) found.push_back(cycle);
  return found;
}

/// "loads along the profile: 3 of 8 cycles have no dem/load.h5 here"; empty where none is missing.
std::vector<std::string> spoken_missing(const char* what, std::size_t found, std::size_t cycles,
                                        const char* file) {
  if (found == cycles) return {};
  return {fmt::format("{}: {} of {} cycles {} no dem/{} here", what, cycles - found, cycles,
                      cycles - found == 1 ? "has" : "have", file)};
}

void add_cycles(const RunFolder& folder, ComparedCampaign& compared) {
  auto& data = compared.data;
  const auto published = published_campaign(compared.campaign.mill, folder);
  const fs::path tables = results_of(compared.campaign.mill, folder);
  data.history = read_history_csv(tables / "history.csv");
  data.life = published_life(tables, data.history, data.life);
  const auto cycles = cycles_of(data.history);
  const auto with_load = with_file(folder, cycles, stage_files::load);
  const auto with_charge = with_file(folder, cycles, stage_files::charge);
  const auto shown = spread(cycles, most_loads);
  data.profiles = profiles_of(published, shown);
  data.loads = loads_of(published, with_file(folder, shown, stage_files::load));
  data.charge = charge_of(published, spread(with_charge, most_charges));
  for (const auto& words : {spoken_missing("loads along the profile", with_load.size(),
                                           cycles.size(), stage_files::load),
                            spoken_missing("maps and particles", with_charge.size(), cycles.size(),
                                           stage_files::charge)})
    compared.missing.insert(compared.missing.end(), words.begin(), words.end());
}

ComparedCampaign compared_campaign(const RunFolder& folder) {
  auto ledger = read_ledger(folder.ledger());
  if (!ledger || !fs::exists(folder.locked_case()))
    throw InputError(
        fmt::format("{}: no campaign is here: it needs case.lock.toml and ledger.jsonl; name "
                    "folders that `millwear run` has worked in",
                    folder.root.string()));
  const Case mill = read_case(folder.locked_case());
  ComparedCampaign compared{{}, {mill, folder, ledger->start.ranks}, results_of_case(mill), {}};
  if (fs::exists(folder.results() / "history.csv") || fs::exists(folder.root / "history.csv"))
    add_cycles(folder, compared);
  if (compared.data.history.empty()) compared.missing = {"no cycle is published yet"};
  return compared;
}

std::string name_of_folder(const fs::path& folder) {
  return fs::weakly_canonical(fs::absolute(folder)).filename().string();
}

}  // namespace

std::vector<ComparedCampaign> compared_campaigns(const std::vector<fs::path>& folders) {
  std::multiset<std::string> names;
  for (const auto& folder : folders) names.insert(name_of_folder(folder));
  std::vector<ComparedCampaign> campaigns;
  for (const auto& folder : folders) {
    campaigns.push_back(compared_campaign({folder}));
    const std::string name = name_of_folder(folder);
    campaigns.back().name = names.count(name) == 1 ? name : folder.string();
  }
  return campaigns;
}

}  // namespace millwear::orchestrator
