#include "orchestrator/app/run_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <ctime>
#include <limits>

#include "mill/base/failure.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_warnings.h"
#include "orchestrator/app/publication.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/cluster/slurm.h"
#include "orchestrator/dem_run/charge_source.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/host_name.h"
#include "orchestrator/results/life_error.h"
#include "orchestrator/stages/run_stage.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t full_disk_bytes = 1 << 20;

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

/// The stage of "3:dem". Throws Failure (usage).
StageId stage_from(const std::string& words) {
  const auto colon = words.find(':');
  int cycle = -1;
  const auto read =
      std::from_chars(words.data(), words.data() + std::min(colon, words.size()), cycle);
  for (const StageKind kind :
       {StageKind::mesh, StageKind::mix, StageKind::tune, StageKind::dem, StageKind::wear})
    if (read.ec == std::errc{} && cycle >= 0 && colon != std::string::npos &&
        words.substr(colon + 1) == name_of(kind))
      return {cycle, kind};
  throw Failure(ExitCode::usage,
                fmt::format("--until {}: no stage; write CYCLE:STAGE, such as 3:dem", words));
}

/// The campaign as its next load is to be measured.
Campaign as_measured(const Campaign& campaign, const Ledger& so_far, Progress& progress) {
  Campaign measured = campaign;
  double& revolutions = measured.mill.dem.measure_revolutions;
  revolutions = revolutions_of_next_load(campaign, so_far);
  if (revolutions > campaign.mill.dem.measure_revolutions)
    progress.say(
        fmt::format("the next load is measured for {:.3g} revolutions, for the life to be "
                    "known to {:.3g} %",
                    revolutions, 100.0 * *campaign.mill.campaign.target_life_error));
  return measured;
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

enum class Explanation { next_stage, every_stage };

void explain_campaign(const OpenCampaign& opened, Explanation how) {
  if (const auto next = next_stage(opened.ledger, plan_of(opened.campaign.mill)))
    fmt::print("{} would run next, because {}; then the rest of the campaign\n",
               name_of(next->stage), next->why);
  else
    fmt::print("nothing is left to run: the campaign ended ({})\n",
               name_of(outcome_of(opened.ledger)));
  if (how == Explanation::every_stage)
    for (const auto& entry : opened.ledger.entries)
      fmt::print("{} is up to date: its {} files are as they were published\n",
                 name_of(entry.stage), entry.outputs.size());
}

/// Refuses a charge that is not there, or of another mill, before anything is written.
void check_charge_source(const OpenCampaign& opened) {
  const Campaign& campaign = opened.campaign;
  if (opened.ledger.find({0, StageKind::mix}) == nullptr)
    static_cast<void>(
        charge_source(campaign.mill, campaign.folder.root / *campaign.mill.dem.charge_from));
}

/// The same run as a batch job. What there is to do is known now; what it costs is an estimate.
void submit_campaign(const RunOptions& options, const Case& mill, const RunFolder& folder) {
  const int ranks = options.ranks.value_or(ranks_for(mill));
  std::vector<std::string> command = {fs::read_symlink("/proc/self/exe").string(),
                                      "run",
                                      fs::absolute(options.common.case_file).string(),
                                      "--out",
                                      fs::absolute(folder.root).string(),
                                      "--ranks",
                                      std::to_string(ranks),
                                      "--quiet"};
  if (options.seed) command.insert(command.end(), {"--seed", std::to_string(*options.seed)});
  if (options.scratch) command.insert(command.end(), {"--scratch", options.scratch->string()});
  if (options.until) command.insert(command.end(), {"--until", *options.until});
  const CostEstimate cost = estimate_cost(mill, ranks);
  const auto job =
      submit_work({mill.name, folder.root / "slurm", command, ranks, campaign_seconds(mill, cost),
                   cost.longest_chunk, memory_for(mill, ranks)},
                  submission_from(options.slurm, {}), std::nullopt, {});
  if (!job.empty())
    fmt::print("submitted as job {}; `millwear status {}` says how far it is\n", job,
               options.common.case_file.string());
}

Case case_to_run(const RunOptions& options) {
  Case mill = read_case(options.common.case_file, read_drawn_liner);
  if (options.seed) mill.dem.seed = *options.seed;
  return mill;
}

}  // namespace

void add_options(CLI::App& verb, RunOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  add_ranks(verb, options.ranks);
  verb.add_option("--seed", options.seed,
                  "Seed of the first packing, instead of the case's; campaigns with other seeds "
                  "show how far chance goes, each in its own folder (--out)")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  verb.add_option(
      "--until", options.until,
      "Run no further than a stage, CYCLE:STAGE with mesh, mix, tune, dem or wear, such "
      "as 3:dem; nothing where it is published");
  verb.add_option("--shared", options.shared,
                  "Folder in which campaigns leave their DEM for each other: what another has "
                  "simulated to the bit is taken from there");
  verb.add_option("--scratch", options.scratch,
                  "Folder on a disk of this machine in which the files of a stage grow, where the "
                  "campaign's own is on slow shared storage");
  verb.add_flag("--dry-run", options.dry_run, "Say which stages would run, and run none");
  verb.add_flag("--explain", options.explain, "Say why each stage runs");
  add_options(verb, options.slurm);
}

void run_verb(const RunOptions& options) {
  const Case mill = case_to_run(options);
  const RunFolder folder = run_folder_of(mill, options.out);
  check_campaign_folder("--out", folder.root);
  const auto open = [&] {
    return campaign_to_run(
        mill, folder, {program_version(), options.ranks.value_or(ranks_for(mill)), host_name()},
        options.ranks);
  };
  const auto how = options.explain ? Explanation::every_stage : Explanation::next_stage;
  if (options.dry_run) return explain_campaign(open(), how);
  if (mill.dem.charge_from) check_charge_source(open());
  check_liggghts_is_installed(mill.dem);
  if (options.slurm.asked()) return submit_campaign(options, mill, folder);

  make_folder(folder.root);
  const RunLock lock(folder.lock(), patience_of_a_job());
  OpenCampaign opened = open();
  opened.campaign.shared_stages = options.shared;
  opened.campaign.scratch = options.scratch;
  keep_start(opened);
  if (options.explain) explain_campaign(opened, how);

  Progress progress(options.common.verbosity);
  if (lock.is_lease())
    progress.say(
        fmt::format("warning: {} is on a file system without locks; the file .lock.lease "
                    "keeps others out, and is left for five minutes where this host dies",
                    folder.root.string()));
  for (const auto& warning : warnings(mill)) progress.say("warning: " + warning);
  const Campaign& campaign = opened.campaign;
  Ledger so_far = opened.ledger;
  const CampaignEffects effects{
      [&](const StageId& stage) {
        const bool is_load = stage.kind == StageKind::dem;
        return run_and_tell(is_load ? as_measured(campaign, so_far, progress) : campaign, stage,
                            progress);
      },
      [&](const LedgerEntry& entry) {
        append_entry(folder.ledger(), entry);
        so_far.entries.push_back(entry);
      },
      [&](const Ledger& published) {
        const CampaignResults data = publish_campaign({campaign, published}, {});
        progress.say(fmt::format("cycle {}: {}", published.entries.back().stage.cycle,
                                 spoken_outcome(data)));
      }};
  CampaignPlan plan = plan_of(mill);
  if (options.until) plan.until = stage_from(*options.until);
  const Ledger finished = run_campaign(opened.ledger, plan, effects);
  // Once more at the end: an earlier process may have died between its last stage and its results.
  CampaignResults data = publish_campaign({campaign, finished}, {});
  publish_pictures_if_possible({campaign, finished}, data, progress);
  progress.detail(fmt::format("{:.1f} s of processor time went elsewhere than into LIGGGHTS",
                              static_cast<double>(std::clock()) / CLOCKS_PER_SEC));
  print_outcome(options.common.form, folder, data);
}

}  // namespace millwear::orchestrator
