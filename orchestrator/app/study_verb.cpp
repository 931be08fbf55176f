#include "orchestrator/app/study_verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/cluster/study_jobs.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/process/usable_cores.h"
#include "orchestrator/study/base_charge.h"
#include "orchestrator/study/design_search.h"
#include "orchestrator/study/search_study.h"
#include "orchestrator/study/study_page.h"
#include "orchestrator/study/study_results.h"
#include "orchestrator/study/study_tables.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

Study study_from(const StudyOptions& options) {
  Study study = options.axes.empty() ? read_study(options.common.case_file)
                                     : study_of_case(options.common.case_file, options.axes);
  if (options.replicates) study.replicates = *options.replicates;
  study.charge_from_base = study.charge_from_base || options.charge_from_base;
  if (options.objective) study.objective = objective_from(*options.objective);
  if (const std::size_t points = point_count(study); points > options.most_points)
    throw Failure(
        ExitCode::usage,
        fmt::format("{}: the study has {} points, and --most-points allows {}; vary less, "
                    "or allow more",
                    study.file.string(), points, options.most_points));
  return study;
}

std::vector<std::string> command_for(const fs::path& folder, int ranks,
                                     const std::optional<fs::path>& scratch) {
  std::vector<std::string> words = {fs::read_symlink("/proc/self/exe").string(),
                                    "run",
                                    (folder / "case.toml").string(),
                                    "--shared",
                                    (folder.parent_path().parent_path() / "shared").string(),
                                    "--out",
                                    folder.string(),
                                    "--ranks",
                                    std::to_string(ranks),
                                    "--quiet"};
  if (scratch) words.insert(words.end(), {"--scratch", scratch->string()});
  return words;
}

/// Mixes the base case on all cores, or those that it names.
std::vector<std::string> base_charge_command(const Study& study, const StudyFolder& folder) {
  return {fs::read_symlink("/proc/self/exe").string(),
          "run",
          study.case_file.string(),
          "--until",
          "0:mix",
          "--out",
          folder.base_charge().string(),
          "--quiet"};
}

void print_plan(const StudyPlan& plan, const std::vector<fs::path>& folders,
                const std::vector<StateOfCampaign>& states, const JobShare& share) {
  double seconds = 0.0;
  for (std::size_t i = 0; i < plan.campaigns.size(); ++i) {
    const StudyCampaign& campaign = plan.campaigns[i];
    std::string values;
    for (std::size_t axis = 0; axis < plan.study.axes.size(); ++axis)
      values += fmt::format("{} = {}, ", plan.study.axes[axis].key,
                            plan.points[campaign.point].labels[axis]);
    fmt::print(
        "{}  {}seed {}: {} particles, time step {:.3g} s, about {} of DEM; "
        "{}\n",
        folders[i].filename().string(), values, campaign.seed, campaign.particles,
        campaign.time_step, spoken_time(campaign.cost / share.ranks), states[i].why);
    if (states[i].state != CampaignState::done) seconds += campaign.cost / share.ranks;
  }
  fmt::print(
      "{} points, {} campaigns, {} side by side on {} rank{} each: about {} for all that are "
      "to run (within a factor of three)\n",
      plan.points.size(), plan.campaigns.size(), share.jobs, share.ranks,
      share.ranks == 1 ? "" : "s", spoken_time(seconds / share.jobs));
}

void publish_study(const StudyFolder& folder, const StudyResults& results) {
  publish(folder.table(), study_csv(results));
  publish(folder.json(), study_json(results));
  publish(folder.page(), study_html(results, installed_d3()));
}

/// What a study works with.
struct StudyWork {
  const StudyOptions& options;
  StudyFolder folder;
  JobShare share;
  Progress& progress;
};

StudyRun study_run(const StudyWork& work) {
  return {work.share.jobs,
          work.share.ranks,
          work.options.on_fail,
          work.options.retry_failed ? Failed::retry : Failed::leave,
          [&options = work.options](const fs::path& folder, int ranks) {
            return command_for(folder, ranks, options.scratch);
          },
          work.options.only};
}

/// The work of one task of an array: some campaigns, beside other tasks, so without the study's
/// lock.
void run_only(const StudyWork& work, const StudyPlan& plan) {
  const auto folders = folders_of(work.folder, plan);
  for (const auto& name : work.options.only)
    if (std::ranges::none_of(folders,
                             [&](const fs::path& one) { return one.filename().string() == name; }))
      throw InputError(
          fmt::format("{}: no campaign of the study is called {}; the study has changed since it "
                      "was submitted, "
                      "so submit it again",
                      work.folder.root.string(), name));
  if (plan.study.charge_from_base && !has_base_charge(work.folder))
    throw ExternalProgramError(fmt::format(
        "{}: the base case's charge is not mixed; see slurm/charge.log, and submit the study again",
        work.folder.root.string()));
  const int failed = run_campaigns(work.folder, plan, folders, study_run(work), work.progress);
  if (failed > 0)
    throw Failure(ExitCode::external_program_failed,
                  fmt::format("{} of {} campaigns failed; see run.log in their folders", failed,
                              work.options.only.size()));
}

/// The words that run this study here, wherever a job begins.
std::vector<std::string> study_words(const StudyOptions& options, const StudyFolder& folder) {
  std::vector<std::string> words = {fs::read_symlink("/proc/self/exe").string(), "study",
                                    fs::absolute(options.common.case_file).string(), "--out",
                                    fs::absolute(folder.root).string()};
  for (const auto& axis : options.axes) words.insert(words.end(), {"--axis", axis});
  if (options.replicates)
    words.insert(words.end(), {"--replicates", std::to_string(*options.replicates)});
  if (options.objective) words.insert(words.end(), {"--objective", *options.objective});
  if (options.charge_from_base) words.push_back("--charge-from-base");
  words.insert(words.end(), {"--most-points", std::to_string(options.most_points)});
  if (options.retry_failed) words.push_back("--retry-failed");
  if (options.scratch) words.insert(words.end(), {"--scratch", options.scratch->string()});
  return words;
}

void submit_plan(const StudyOptions& options, const StudyFolder& folder, const StudyPlan& plan,
                 const JobShare& share) {
  const auto folders = folders_of(folder, plan);
  if (!options.slurm.test) {
    keep_plan(folder, plan, folders);
    link_by_value(folder, plan, folders);
  }
  SlurmSettings settings =
      options.axes.empty() ? slurm_settings_of(plan.study.file) : SlurmSettings{};
  if (options.bundle) settings.bundle = *options.bundle;
  const auto submitted = submit_study({plan, folder, folders, states_of(folder, folders),
                                       study_words(options, folder), share.ranks},
                                      submission_from(options.slurm, std::move(settings)));
  if (options.slurm.test) return;
  if (submitted.campaigns == 0)
    fmt::print("nothing to submit: every campaign is done, failed or in the queue\n");
  else
    fmt::print("submitted {} campaigns as job {}, and {} that gathers them\n", submitted.campaigns,
               fmt::join(submitted.arrays, ", "), submitted.gathering);
}

/// Runs what is missing of a plan and returns what is known then.
StudyResults results_of(const StudyWork& work, const StudyPlan& plan) {
  const auto folders = folders_of(work.folder, plan);
  keep_plan(work.folder, plan, folders);
  link_by_value(work.folder, plan, folders);
  const auto states = states_of(work.folder, folders);
  const bool is_done = std::ranges::all_of(
      states, [](const StateOfCampaign& one) { return one.state == CampaignState::done; });
  if (plan.study.charge_from_base && !is_done)
    mix_base_charge(work.folder, base_charge_command(plan.study, work.folder), work.progress);
  run_campaigns(work.folder, plan, folders, study_run(work), work.progress);
  return study_results(plan, folders, states_of(work.folder, folders));
}

/// What is known of a plan, without running anything.
StudyResults gathered(const StudyWork& work, const StudyPlan& plan) {
  const auto folders = folders_of(work.folder, plan);
  return study_results(plan, folders, states_of(work.folder, folders));
}

/// Tries as many points as the search may, so many at once as run side by side. The places stand in
/// `search.csv` before they are run.
StudyResults search(const StudyWork& work, const Study& study) {
  const fs::path file = work.folder.search();
  auto places = read_places(file, study);
  const auto budget = static_cast<std::size_t>(study.samples);
  std::vector<SearchValue> found;
  for (;;) {
    if (!places.empty()) {
      StudyResults results = results_of(work, plan_of(with_places(study, places)));
      if (places.size() >= budget) return results;
      found = values_of(results, places);
    }
    const std::size_t count =
        std::min(budget - places.size(), static_cast<std::size_t>(work.share.jobs));
    for (auto& place : next_places(intervals_of(study), found, count, study.seed))
      places.push_back(std::move(place));
    write_places(file, study, places);
  }
}

void print_results(const StudyOptions& options, const StudyFolder& folder,
                   const StudyResults& results) {
  if (options.common.form == OutputForm::json)
    fmt::print("{}", study_json(results));
  else
    fmt::print("{}page: {}\n", study_text(results), folder.page().string());
  const auto failed = std::ranges::count_if(results.states, [](const StateOfCampaign& one) {
    return one.state == CampaignState::failed;
  });
  if (failed > 0)
    throw Failure(ExitCode::external_program_failed,
                  fmt::format("{} campaign{} failed; see run.log in {}, and give --retry-failed to "
                              "try again",
                              failed, failed == 1 ? "" : "s", folder.points().string()));
}

}  // namespace

void add_options(CLI::App& verb, StudyOptions& options) {
  add_options(verb, options.common);
  const std::map<std::string, OnFail> on_fail{{"continue", OnFail::go_on}, {"stop", OnFail::stop}};
  verb.add_option("--axis", options.axes,
                  "Vary a key of the case, which then stands in the place of the study file: "
                  "KEY=VALUE,VALUE or KEY=LOW:HIGH:STEP; may be given more than once")
      ->allow_extra_args(false);
  verb.add_option("--objective", options.objective,
                  "What best means: \"maximise life_hours\", \"minimise power_w / life_hours\"");
  verb.add_option("--replicates", options.replicates,
                  "Campaigns of each point that differ in the seed, instead of the study's")
      ->check(CLI::Range(1, 1000));
  verb.add_flag("--charge-from-base", options.charge_from_base,
                "Mix the base case once and begin every campaign with its charge");
  verb.add_option("--out", options.out, "Folder of the study; by default studies/NAME");
  verb.add_option("--jobs", options.jobs,
                  "Campaigns side by side, by default as many as there are cores; the ranks of all "
                  "never pass the cores")
      ->check(CLI::Range(1, 100000));
  verb.add_option("--most-points", options.most_points, "Refuse a study with more points")
      ->capture_default_str();
  verb.add_option(
          "--on-fail", options.on_fail,
          "What becomes of the others once a campaign failed: continue (by default) or stop")
      ->transform(CLI::CheckedTransformer(on_fail).description(""));
  verb.add_flag("--retry-failed", options.retry_failed, "Try campaigns again that failed before");
  verb.add_flag("--dry-run", options.dry_run,
                "Print every campaign with its cost and why it would run, and run none");
  verb.add_flag("--explain", options.explain, "Print the same, and run");
  verb.add_option("--scratch", options.scratch,
                  "Folder on a disk of this machine in which the files of the DEM grow");
  verb.add_option("--only", options.only,
                  "Run the campaigns in these folders of `points` alone (commas between them), and "
                  "gather nothing")
      ->delimiter(',');
  verb.add_flag("--only-charge", options.only_charge,
                "Mix the charge of the base case and no more");
  verb.add_flag("--gather", options.gather,
                "Write tables and page of what there is, and run nothing");
  add_options(verb, options.slurm);
  verb.add_option("--bundle", options.bundle,
                  "Campaigns that one task of Slurm runs, one after the other; by default the "
                  "study file's, or one")
      ->check(CLI::Range(1, 100000));
}

void study_verb(const StudyOptions& options) {
  const Study study = study_from(options);
  check_columns(study);
  const StudyFolder folder{options.out.empty() ? fs::path("studies") / study.name : options.out};
  check_output_folder("--out", folder.root);
  const Case base = read_case(study.case_file, read_drawn_liner);
  const JobShare share = job_share(usable_cores(), options.jobs, base.dem.ranks);
  const bool is_search = study.combine == Combine::search;
  const StudyPlan plan = plan_so_far(folder, study);
  if (options.dry_run || options.explain) {
    const auto folders = folders_of(folder, plan);
    print_plan(plan, folders, states_of(folder, folders), share);
    if (is_search)
      fmt::print("{} of {} points are chosen; the others follow from their results\n",
                 plan.points.size(), study.samples);
  }
  if (options.dry_run) return;
  check_liggghts_is_installed(base.dem);

  if (options.slurm.asked() && is_search)
    throw Failure(ExitCode::usage,
                  "a search chooses its points one after the other, so it is not submitted as an "
                  "array; run it inside one job");
  if (options.slurm.test) return submit_plan(options, folder, plan, share);

  make_folder(folder.root);
  Progress progress(options.common.verbosity);
  const StudyWork work{options, folder, share, progress};
  if (options.only_charge)
    return mix_base_charge(folder, base_charge_command(study, folder), progress);
  if (!options.only.empty()) return run_only(work, plan);
  const RunLock lock(folder.lock());
  if (options.slurm.submit) return submit_plan(options, folder, plan, share);
  const StudyResults results = options.gather ? gathered(work, plan)
                               : is_search    ? search(work, study)
                                              : results_of(work, plan);
  publish_study(folder, results);
  print_results(options, folder, results);
}

}  // namespace millwear::orchestrator
