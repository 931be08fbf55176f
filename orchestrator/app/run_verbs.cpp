#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/number_or_null.h"
#include "mill/base/published_file.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/case_file/case_warnings.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/verbs.h"
#include "orchestrator/calibration/course_calibration.h"
#include "orchestrator/campaign/lowered_limits.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/report/report_files.h"
#include "orchestrator/results/gather.h"
#include "orchestrator/results/result_files.h"
#include "orchestrator/stages/run_stage.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t full_disk_bytes = 1 << 20;

RunFolder folder_of(const Command& command, const Case& mill) {
  return {command.out.empty() ? fs::path("runs") / mill.name : command.out};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

CampaignStart start_of(const Command& command, const Case& mill) {
  return {program_version(), hash_of_text(locked_case_text(mill)),
          command.ranks.value_or(ranks_for(mill)), host_name()};
}

/// Throws InputError where the folder holds another case's campaign.
void check_same_case(const Command& command, const Ledger& ledger, const std::string& case_hash,
                     const RunFolder& folder) {
  if (ledger.start.case_hash != case_hash)
    throw InputError(fmt::format(
        "{}: the case differs from the one that {} was begun with ({} has that one in full); "
        "`millwear run` goes on where only limits are lower; give another folder with --out, or "
        "move this one away",
        command.case_file.string(), folder.root.string(), folder.locked_case().string()));
}

/// The ledger in the folder, or a new one; of a campaign whose limits the case lowers, as it goes
/// on. Throws where the folder holds another case's campaign.
Ledger ledger_for(const Command& command, const Case& mill, const RunFolder& folder) {
  const CampaignStart start = start_of(command, mill);
  auto ledger = read_ledger(folder.ledger());
  if (!ledger) return {start, {}};
  if (ledger->start.case_hash != start.case_hash && fs::exists(folder.locked_case()) &&
      only_lowers_limits(mill, read_case(folder.locked_case())))
    ledger = reopened(std::move(*ledger), start.case_hash);
  check_same_case(command, *ledger, start.case_hash, folder);
  if (command.ranks && *command.ranks != ledger->start.ranks)
    throw Failure(ExitCode::usage,
                  fmt::format("{} was begun with {} ranks and goes on with the same; leave --ranks "
                              "out, or run into another folder with --out",
                              folder.root.string(), ledger->start.ranks));
  check_outputs(*ledger, folder.root);
  return *ledger;
}

/// Writes case and ledger where there are none yet, or those of higher limits. The case first: with
/// it alone the campaign can still be taken up.
void keep_start(const RunFolder& folder, const Ledger& ledger, const Case& mill) {
  const auto kept = read_ledger(folder.ledger());
  if (kept && !ledger.entries.empty() && kept->start.case_hash == ledger.start.case_hash) return;
  publish(folder.locked_case(), locked_case_text(mill));
  write_ledger(folder.ledger(), ledger);
}

/// The case's campaign in the folder; throws if there is none.
Ledger existing_ledger(const Command& command, const Case& mill, const RunFolder& folder) {
  auto ledger = read_ledger(folder.ledger());
  if (!ledger)
    throw Failure(ExitCode::usage,
                  fmt::format("{}: no campaign is here; start one with `millwear run {}`",
                              folder.root.string(), command.case_file.string()));
  check_same_case(command, *ledger, hash_of_text(locked_case_text(mill)), folder);
  return *ledger;
}

std::string spoken_outcome(const ReportData& data) {
  if (data.history.empty()) return "no cycle is finished yet";
  const auto& last = data.history.back();
  const std::string band = std::isfinite(data.life.hours_low)
                               ? fmt::format(" (95 % band {:.0f} to {:.0f} h)", data.life.hours_low,
                                             data.life.hours_high)
                               : "";
  return fmt::format("{} {:.0f} h{}: lifter {:.1f} mm high, plate {:.1f} mm thick, {} cycles",
                     data.life.reached ? "worn out at" : "worn for", last.operating_hours, band,
                     1e3 * last.lifter_height, 1e3 * last.plate_thickness,
                     data.conservation.size());
}

void print_outcome(const Command& command, const RunFolder& folder, const ReportData& data) {
  if (command.form == OutputForm::json) {
    fmt::print("{}\n", read_file(folder.results() / "summary.json"));
    return;
  }
  fmt::print("{}\nreport: {}\n", spoken_outcome(data), folder.report().string());
}

/// What a stage adds to the share of the liner's life: measuring and wearing take a cycle's share,
/// expected to be that of the cycle before. How far the first load of the adaptive scheme goes is
/// not known beforehand.
struct StageShare {
  double before;
  double after;
};

StageShare share_of(const Campaign& campaign, const StageId& stage) {
  const double now = share_of_life(campaign.mill, liner_of_cycle(campaign, stage.cycle));
  if (stage.kind != StageKind::dem) return {now, now};
  const double earlier =
      stage.cycle == 0 ? 0.0
                       : share_of_life(campaign.mill, liner_of_cycle(campaign, stage.cycle - 1));
  const auto& settings = campaign.mill.campaign;
  const double first = settings.scheme == Scheme::threshold ? settings.threshold : 0.0;
  const double gain = stage.cycle == 0 ? first : now - earlier;
  return {now, std::min(1.0, now + gain)};
}

/// A stage's failure with its name. On a disk without room it is the disk's failure, whatever gmsh
/// or LIGGGHTS made of it.
Failure failure_of_stage(const Campaign& campaign, const StageId& stage, const Failure& failure) {
  std::error_code unknown;
  const auto free = fs::space(campaign.folder.root, unknown).available;
  if (unknown || free >= full_disk_bytes)
    return {failure.exit_code, fmt::format("{}: {}", name_of(stage), failure.what())};
  return DiskError(
      fmt::format("{}: the disk is full ({} kB are free); free some, then the same "
                  "command goes on: {}",
                  name_of(stage), free >> 10, failure.what()));
}

LedgerEntry run_and_tell(const Campaign& campaign, const StageId& stage, Progress& progress) {
  stop_if_interrupted();
  const auto share = share_of(campaign, stage);
  progress.begin(name_of(stage), share.before, share.after);
  try {
    const LedgerEntry entry = run_stage(campaign, stage, progress);
    progress.end();
    progress.detail(fmt::format("{} took {:.2f} s", name_of(stage), entry.wall_seconds));
    return entry;
  } catch (const Failure& failure) {
    throw failure_of_stage(campaign, stage, failure);
  }
}

/// A table that cannot be taken does not stop a campaign, unless it was asked for by name.
void add_readings_of(const Command& command, const Case& mill, ReportData& data) {
  try {
    const auto readings = readings_in(gauge_folder(mill, command.readings), mill);
    add_readings(readings, data);
    add_calibrated_course(mill, readings, data);
  } catch (const InputError& problem) {
    if (command.readings) throw;
    data.warnings.push_back(fmt::format("the gauge readings are left out: {}", problem.what()));
  }
}

ReportData publish_campaign(const Command& command, const Campaign& campaign,
                            const Ledger& ledger) {
  ReportData data = gather(campaign, ledger);
  add_readings_of(command, campaign.mill, data);
  publish_results(campaign, ledger, data);
  publish_report(campaign.folder.report(), data);
  return data;
}

/// The pictures are a convenience: a campaign does not fail for want of gnuplot.
void publish_pictures_if_possible(const Campaign& campaign, const ReportData& data,
                                  Progress& progress) {
  try {
    publish_pictures(campaign.folder.results(), data);
  } catch (const ExternalProgramError& problem) {
    progress.say(std::string("no pictures in results/: ") + problem.what());
  }
}

void explain_campaign(const Command& command, const Ledger& ledger, const Case& mill) {
  if (const auto next = next_stage(ledger, plan_of(mill)))
    fmt::print("{} would run next, because {}; then the rest of the campaign\n",
               name_of(next->stage), next->why);
  else
    fmt::print("nothing is left to run: the campaign ended ({})\n", name_of(outcome_of(ledger)));
  if (command.explain)
    for (const auto& entry : ledger.entries)
      fmt::print("{} is up to date: its {} files are as they were published\n",
                 name_of(entry.stage), entry.outputs.size());
}

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

}  // namespace

void run_verb(const Command& command) {
  Case mill = read_case(command.case_file);
  const RunFolder folder = folder_of(command, mill);
  if (command.dry_run) return explain_campaign(command, ledger_for(command, mill, folder), mill);
  check_liggghts_is_installed(mill.dem.contact_path);

  make_folder(folder.root);
  const RunLock lock(folder.lock());
  const Ledger ledger = ledger_for(command, mill, folder);
  keep_start(folder, ledger, mill);
  if (command.explain) explain_campaign(command, ledger, mill);

  Progress progress(command.verbosity);
  for (const auto& warning : warnings(mill)) progress.say("warning: " + warning);
  const Campaign campaign{std::move(mill), folder, ledger.start.ranks};
  const CampaignEffects effects{
      [&](const StageId& stage) { return run_and_tell(campaign, stage, progress); },
      [&](const LedgerEntry& entry) { append_entry(folder.ledger(), entry); },
      [&](const Ledger& so_far) {
        const ReportData data = publish_campaign(command, campaign, so_far);
        progress.say(
            fmt::format("cycle {}: {}", so_far.entries.back().stage.cycle, spoken_outcome(data)));
      }};
  const Ledger finished = run_campaign(ledger, plan_of(campaign.mill), effects);
  // Once more at the end: an earlier process may have died between its last stage and its results.
  const ReportData data = publish_campaign(command, campaign, finished);
  publish_pictures_if_possible(campaign, data, progress);
  progress.detail(fmt::format("{:.1f} s of processor time went elsewhere than into LIGGGHTS",
                              static_cast<double>(std::clock()) / CLOCKS_PER_SEC));
  print_outcome(command, folder, data);
}

void status_verb(const Command& command) {
  const Case mill = read_case(command.case_file);
  const RunFolder folder = folder_of(command, mill);
  const Ledger ledger = existing_ledger(command, mill, folder);
  const Campaign campaign{mill, folder, ledger.start.ranks};
  const bool running = is_locked(folder.lock());
  const auto next = next_stage(ledger, plan_of(mill));
  int next_cycle = 0;
  while (ledger.find({next_cycle, StageKind::wear}) != nullptr) ++next_cycle;
  const LinerProfile liner = liner_of_cycle(campaign, next_cycle);
  const auto measured = latest_measurement(campaign, ledger);
  const bool reversed = rotation_of_cycle(campaign, next_cycle) == Rotation::reversed;
  if (command.form == OutputForm::json) {
    fmt::print("{}\n", nlohmann::json{{"running", running},
                                      {"outcome", name_of(outcome_of(ledger))},
                                      {"cycles", next_cycle},
                                      {"next", next ? name_of(next->stage) : ""},
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
  if (!mill.campaign.reversal_times.empty())
    fmt::print("turning {}\n", reversed ? "the other way than when the liner was new"
                                        : "as when the liner was new");
  if (running)
    fmt::print("running: {}\n", next ? name_of(next->stage) : "gathering the results");
  else if (next)
    fmt::print("not running; `millwear run {}` goes on with {}\n", command.case_file.string(),
               name_of(next->stage));
  else
    fmt::print("finished: {}\n", name_of(outcome_of(ledger)));
}

void report_verb(const Command& command) {
  const Case mill = read_case(command.case_file);
  const RunFolder folder = folder_of(command, mill);
  const Ledger ledger = existing_ledger(command, mill, folder);
  const RunLock lock(folder.lock());
  check_outputs(ledger, folder.root);
  const Campaign campaign{mill, folder, ledger.start.ranks};
  const ReportData data = publish_campaign(command, campaign, ledger);
  Progress progress(command.verbosity);
  publish_pictures_if_possible(campaign, data, progress);
  print_outcome(command, folder, data);
}

}  // namespace millwear::orchestrator
