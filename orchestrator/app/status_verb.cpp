#include "orchestrator/app/status_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/number_or_null.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/study_status.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/stretch/chunk_run.h"
#include "orchestrator/study/study_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// The newest load and its cycle, if there is one.
std::optional<std::pair<int, Measured>> latest_measurement(const Campaign& campaign,
                                                           const Ledger& ledger) {
  int cycles = 0;
  while (ledger.find({cycles, StageKind::dem}) != nullptr) ++cycles;
  if (cycles == 0) return std::nullopt;
  const StageId stage{cycles - 1, StageKind::dem};
  return std::pair{stage.cycle,
                   read_measured(campaign.folder.stage(stage) / stage_files::measured)};
}

nlohmann::json latest_measurement_json(const std::optional<std::pair<int, Measured>>& measured) {
  if (!measured) return nullptr;
  const auto& [cycle, load] = *measured;
  return {{"cycle", cycle},
          {"revolutions", load.revolutions},
          {"peak_relative_error", number_or_null(load.peak_error)},
          {"ended", name_of(end_of(load))}};
}

/// With the folder of a campaign or a study in place of the case file: what it was begun with.
/// Throws Failure (usage) where the folder is neither.
StatusOptions with_case_of_folder(StatusOptions options) {
  fs::path& file = options.common.case_file;
  if (!fs::is_directory(file) || !options.out.empty()) return options;
  options.out = file;
  const StudyFolder study{file};
  const RunFolder run{file};
  file = fs::exists(study.locked_study()) ? study.locked_study() : run.locked_case();
  if (!fs::exists(file))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: neither a campaign nor a study is here; name its folder, or its "
                              "case or study file",
                              options.out.string()));
  return options;
}

}  // namespace

void add_options(CLI::App& verb, StatusOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
}

void status_verb(const StatusOptions& told) {
  const StatusOptions options = with_case_of_folder(told);
  if (const auto study = study_folder_of(options.common.case_file, options.out))
    return print_study_status(*study, options.common.form);
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const RunFolder folder = run_folder_of(mill, options.out);
  const auto [campaign, ledger] = campaign_of(mill, folder);
  const bool running = is_locked(folder.lock());
  const auto next = next_stage(ledger, plan_of(mill));
  int next_cycle = 0;
  while (ledger.find({next_cycle, StageKind::wear}) != nullptr) ++next_cycle;
  const LinerProfile liner = liner_of_cycle(campaign, next_cycle);
  const auto measured = latest_measurement(campaign, ledger);
  const bool reversed = rotation_of_cycle(campaign, next_cycle) == Rotation::reversed;
  if (options.common.form == OutputForm::json) {
    fmt::print("{}\n",
               nlohmann::json{{"running", running},
                              {"outcome", name_of(outcome_of(ledger))},
                              {"cycles", next_cycle},
                              {"next", next ? name_of(next->stage) : ""},
                              {"chunks_done", next ? chunks_done(campaign, next->stage) : 0},
                              {"latest_load", latest_measurement_json(measured)},
                              {"reversed", reversed},
                              {"lifter_height_m", lifter_height(liner)},
                              {"share_of_life", share_of_life(mill, liner)}}
                   .dump(1));
    return;
  }
  fmt::print("{}: {} cycles done, lifter {:.1f} mm high, {:.0f} % of the way to its limit\n",
             folder.root.string(), next_cycle, 1e3 * lifter_height(liner),
             100.0 * share_of_life(mill, liner));
  if (measured)
    fmt::print("latest load (cycle {}): {}\n", measured->first, spoken_end(measured->second));
  if (!mill.campaign.reversal_times.empty() || reversed)
    fmt::print("turning {}\n", reversed ? "the other way than when the liner was new"
                                        : "as when the liner was new");
  const int chunks = next ? chunks_done(campaign, next->stage) : 0;
  const std::string done_of_it = chunks > 0 ? fmt::format(", {} of its chunks done", chunks) : "";
  if (running)
    fmt::print("running: {}{}\n", next ? name_of(next->stage) : "gathering the results",
               done_of_it);
  else if (next)
    fmt::print("not running; `millwear run {}{}` goes on with {}{}\n",
               options.common.case_file.string(),
               options.out.empty() ? "" : " --out " + options.out.string(), name_of(next->stage),
               done_of_it);
  else
    fmt::print("finished: {}\n", name_of(outcome_of(ledger)));
}

}  // namespace millwear::orchestrator
