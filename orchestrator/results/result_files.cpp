#include "orchestrator/results/result_files.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "mill/base/number_or_null.h"
#include "mill/base/published_file.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/loads/spectra.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/landmarks.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/replicates.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// LIGGGHTS's own line about its version, from the first log.
std::string liggghts_version(const Campaign& campaign) {
  const auto log = campaign.folder.stage({0, StageKind::mix}) / "liggghts.log";
  if (!fs::exists(log)) return "";
  const std::string text = read_file(log);
  const auto start = text.find("LIGGGHTS (Version");
  return start == std::string::npos ? "" : text.substr(start, text.find('\n', start) - start);
}

constexpr std::array result_names{"history.csv", "profiles.csv",  "replicates.csv",
                                  "bins.h5",     "landmarks.csv", "spectra.csv"};

json outputs_of(const Ledger& ledger, const RunFolder& folder) {
  json outputs = json::object();
  for (const char* name : result_names)
    outputs[(folder.results() / name).lexically_relative(folder.root).string()] =
        hash_of_file(folder.results() / name);
  for (const auto& entry : ledger.entries)
    for (const auto& [name, hash] : entry.outputs)
      outputs[(folder.stage(entry.stage) / name).lexically_relative(folder.root).string()] = hash;
  return outputs;
}

std::string summary_json(const Campaign& campaign, const Ledger& ledger,
                         const CampaignResults& data) {
  const double removed = data.history.empty() ? 0.0 : data.history.back().worn_volume;
  double accounted = 0.0;
  json paths = json::array();
  for (const auto& cycle : data.conservation) {
    accounted += cycle.accounted;
    paths.push_back(number_or_null(cycle.path_over_slip));
  }
  const json summary = {
      {"type", "millwear summary"},
      {"format_version", 1},
      {"case", campaign.mill.name},
      {"outcome", name_of(outcome_of(ledger))},
      {"life_reached", data.life.reached},
      {"life_hours", number_or_null(data.life.hours)},
      {"life_hours_low", number_or_null(data.life.hours_low)},
      {"life_hours_high", number_or_null(data.life.hours_high)},
      {"life_tonnes", number_or_null(data.life.tonnes)},
      {"limit", data.life.limit},
      {"cycles", data.conservation.size()},
      {"volume_removed_m3_per_m", removed},
      {"volume_accounted_m3_per_m", accounted},
      {"volume_error", accounted > 0.0 ? json(removed / accounted - 1.0) : json(nullptr)},
      {"path_over_slip", paths},
      {"parameters", locked_case_text(campaign.mill)},
      {"case_hash", ledger.start.case_hash},
      {"versions", {{"millwear", program_version()}, {"liggghts", liggghts_version(campaign)}}},
      {"seed", campaign.mill.dem.seed},
      {"ranks", ledger.start.ranks},
      {"host", ledger.start.host},
      {"warnings", data.warnings},
      {"outputs", outputs_of(ledger, campaign.folder)}};
  return summary.dump(1) + "\n";
}

}  // namespace

void publish_results(const Campaign& campaign, const Ledger& ledger, const CampaignResults& data) {
  const fs::path folder = campaign.folder.results();
  fs::create_directories(folder);
  publish(folder / "history.csv", history_csv(data.history));
  publish(folder / "profiles.csv", profiles_csv(data.profiles));
  publish(folder / "replicates.csv", replicates_csv(data.replicates));
  publish_written(folder / "bins.h5",
                  [&](const fs::path& beside) { wear::write_loads(beside, data.bins); });
  publish(folder / "landmarks.csv", landmarks_csv(data.charge.cycles));
  publish(folder / "spectra.csv", spectra_head() + data.spectrum_lines);
  publish(folder / "summary.json", summary_json(campaign, ledger, data));
}

}  // namespace millwear::orchestrator
