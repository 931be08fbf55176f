#include "orchestrator/app/study_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/cluster/study_jobs.h"
#include "orchestrator/study/run_campaigns.h"
#include "orchestrator/study/study_file.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Where one campaign of a study stands.
struct Standing {
  std::string campaign;        ///< name of its folder
  std::string state;           ///< "done", "failed", "running", "queued", "waiting"
  std::optional<double> life;  ///< share of the way to the liner's limit, of one that has begun
  std::string why;
};

/// Share of the way to its limit that a campaign's liner has gone; none before its first wear.
std::optional<double> share_gone(const fs::path& folder) {
  try {
    const Case mill = read_case(folder / "case.toml");
    const auto [campaign, ledger] = campaign_of(mill, {folder});
    int cycles = 0;
    while (ledger.find({cycles, StageKind::wear}) != nullptr) ++cycles;
    return share_of_life(mill, liner_of_cycle(campaign, cycles));
  } catch (const Failure&) {
    return std::nullopt;
  }
}

std::string state_of(const fs::path& folder, CampaignState state,
                     const std::map<std::string, std::string>& queued) {
  if (state == CampaignState::done) return "done";
  if (fs::exists(folder) && is_locked(RunFolder{folder}.lock())) return "running";
  const auto job = queued.find(folder.filename().string());
  if (job != queued.end()) return job->second == "RUNNING" ? "running" : "queued";
  return state == CampaignState::failed ? "failed" : "waiting";
}

std::vector<Standing> standings_of(const StudyFolder& folder) {
  std::vector<fs::path> folders;
  for (const auto& [hash, point] : point_folders(folder)) folders.push_back(point);
  std::ranges::sort(folders);
  const auto states = states_of(folder, folders);
  const auto queued = queued_campaigns(folder);
  std::vector<Standing> standings;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    Standing standing{folders[i].filename().string(),
                      state_of(folders[i], states[i].state, queued),
                      {},
                      states[i].why};
    if (standing.state != "done") standing.life = share_gone(folders[i]);
    standings.push_back(standing);
  }
  return standings;
}

constexpr const char* state_names[] = {"done", "running", "queued", "failed", "waiting"};

std::map<std::string, int> counts_of(const std::vector<Standing>& standings) {
  std::map<std::string, int> counts;
  for (const char* const name : state_names) counts[name] = 0;
  for (const auto& standing : standings) ++counts[standing.state];
  return counts;
}

void print_text(const StudyFolder& folder, const std::vector<Standing>& standings) {
  const auto counts = counts_of(standings);
  std::string line = fmt::format("{}: {} campaigns", folder.root.string(), standings.size());
  for (const char* const name : state_names)
    if (counts.at(name) > 0) line += fmt::format(", {} {}", counts.at(name), name);
  fmt::print("{}\n", line);
  for (const auto& standing : standings) {
    if (standing.state != "running" && standing.state != "failed") continue;
    fmt::print("  {}  {}", standing.campaign, standing.state);
    if (standing.life) fmt::print(", {:.0f} % of the way to its limit", 100.0 * *standing.life);
    if (standing.state == "failed") fmt::print("; {}", standing.why);
    fmt::print("\n");
  }
}

void print_json(const std::vector<Standing>& standings) {
  nlohmann::json campaigns = nlohmann::json::array();
  for (const auto& standing : standings)
    campaigns.push_back(
        {{"campaign", standing.campaign},
         {"state", standing.state},
         {"share_of_life", standing.life ? nlohmann::json(*standing.life) : nlohmann::json()}});
  fmt::print("{}\n",
             nlohmann::json{{"counts", counts_of(standings)}, {"campaigns", campaigns}}.dump(1));
}

}  // namespace

std::optional<StudyFolder> study_folder_of(const fs::path& file, const fs::path& out) {
  const StudyFolder given{out};
  if (!out.empty() && fs::exists(given.locked_study())) return given;
  const CaseTable* const top = read_case_document(file).find("");
  if (top == nullptr || top->find("case") == nullptr) return std::nullopt;
  return out.empty() ? StudyFolder{fs::path("studies") / read_study(file).name} : given;
}

void print_study_status(const StudyFolder& folder, OutputForm form) {
  if (!fs::exists(folder.points()))
    throw Failure(
        ExitCode::usage,
        fmt::format("{}: there is no study yet; `millwear study` begins it", folder.root.string()));
  const auto standings = standings_of(folder);
  if (form == OutputForm::json)
    print_json(standings);
  else
    print_text(folder, standings);
}

}  // namespace millwear::orchestrator
