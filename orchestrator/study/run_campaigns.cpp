#include "orchestrator/study/run_campaigns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <list>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/process/host_name.h"
#include "orchestrator/process/logged_child.h"
#include "orchestrator/study/job_log.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int signalled = 128;  ///< exit codes above are of a signal
constexpr auto between_looks = std::chrono::milliseconds(200);
constexpr auto after_locked = std::chrono::seconds(1);
constexpr auto between_shares = std::chrono::seconds(5);

/// A campaign that runs.
struct RunningCampaign {
  std::size_t number;
  JobRecord record;
  Clock::time_point started;
  std::unique_ptr<ChildProcess> process;
};

/// The share of its life that a campaign has behind it, by its last published wear.
double share_so_far(const fs::path& folder) {
  const auto ledger = read_ledger(RunFolder{folder}.ledger());
  if (!ledger) return 0.0;
  const Campaign campaign{read_case(RunFolder{folder}.locked_case()), {folder}, 1};
  int cycles = 0;
  while (ledger->find({cycles, StageKind::wear}) != nullptr) ++cycles;
  return share_of_life(campaign.mill, liner_of_cycle(campaign, cycles));
}

RunningCampaign started(std::size_t number, const fs::path& folder, const StudyRun& how) {
  const auto command = how.command(folder, how.ranks);
  return {number,
          {folder.filename().string(), host_name(), utc_now(), 0.0, 0,
           fmt::format("{}", fmt::join(command, " "))},
          Clock::now(),
          start_logged(command, folder / "run.log")};
}

/// How the campaigns of a study go on.
struct Course {
  std::deque<std::size_t> waiting;  ///< numbers of campaigns, the next first
  std::list<RunningCampaign> running;
  std::size_t done;
  int failed;
};

void show(const Course& course, const std::vector<fs::path>& all, Progress& progress) {
  std::string shares;
  double share = static_cast<double>(course.done);
  for (const auto& one : course.running) {
    const double of_life = share_so_far(all[one.number]);
    share += of_life;
    shares += fmt::format("{}{:.0f} %", shares.empty() ? "" : ", ", 100.0 * of_life);
  }
  progress.rename(fmt::format("{} of {} done, {} failed, {} running ({})", course.done, all.size(),
                              course.failed, course.running.size(), shares));
  progress.advance(share / static_cast<double>(all.size()));
}

/// Notes how a campaign ended.
void note_end(const StudyFolder& folder, const fs::path& campaign, const JobRecord& record,
              std::size_t of, Course& course, Progress& progress) {
  append_job(folder.jobs(), record);
  if (record.exit != 0) {
    ++course.failed;
    progress.say(fmt::format("{} failed with exit code {}; see {}", record.point, record.exit,
                             (campaign / "run.log").string()));
    return;
  }
  ++course.done;
  progress.say(fmt::format("{} is done after {} ({} of {})", record.point,
                           spoken_time(record.seconds), course.done, of));
}

/// Takes the campaigns that have ended out of those that run.
void take_ended(const StudyFolder& folder, const std::vector<fs::path>& all, const StudyRun& how,
                Course& course, Progress& progress) {
  for (auto one = course.running.begin(); one != course.running.end();) {
    const auto exit = one->process->ended();
    if (!exit) {
      ++one;
      continue;
    }
    if (*exit == static_cast<int>(ExitCode::locked)) {
      // A run that was killed is not gone yet.
      course.waiting.push_back(one->number);
      std::this_thread::sleep_for(after_locked);
    } else {
      one->record.exit = *exit;
      one->record.seconds = std::chrono::duration<double>(Clock::now() - one->started).count();
      note_end(folder, all[one->number], one->record, all.size(), course, progress);
      if (*exit != 0 && how.on_fail == OnFail::stop) course.waiting.clear();
    }
    one = course.running.erase(one);
  }
}

/// The numbers of the campaigns that are to run, the longest first.
std::deque<std::size_t> to_run(const StudyPlan& plan, const std::vector<fs::path>& all,
                               const std::vector<StateOfCampaign>& states, const StudyRun& how) {
  const auto is_asked_for = [&](std::size_t i) {
    return how.only.empty() ||
           std::ranges::find(how.only, all[i].filename().string()) != how.only.end();
  };
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (is_asked_for(i) &&
        (states[i].state == CampaignState::waiting ||
         (states[i].state == CampaignState::failed && how.failed == Failed::retry)))
      numbers.push_back(i);
  std::ranges::stable_sort(numbers, [&](std::size_t a, std::size_t b) {
    return plan.campaigns[a].cost > plan.campaigns[b].cost;
  });
  return {numbers.begin(), numbers.end()};
}

fs::path summary_of(const fs::path& campaign) { return campaign / "results" / "summary.json"; }

/// Whether a campaign with results is not at its end: while it runs it publishes them after every
/// load.
bool goes_on(const fs::path& campaign) {
  const auto summary = nlohmann::json::parse(read_file(summary_of(campaign)), nullptr, false);
  if (summary.is_object() && summary.value("outcome", "") != name_of(Outcome::go_on)) return false;
  // It may have come to its last cycle above its limits.
  const auto ledger = read_ledger(RunFolder{campaign}.ledger());
  return !ledger || next_stage(*ledger, plan_of(read_case(campaign / "case.toml"))).has_value();
}

}  // namespace

std::vector<StateOfCampaign> states_of(const StudyFolder& folder,
                                       const std::vector<fs::path>& all) {
  const auto exits = last_exits(folder.jobs());
  std::vector<StateOfCampaign> states;
  for (const fs::path& campaign : all) {
    const auto job = exits.find(campaign.filename().string());
    if (job == exits.end())
      states.push_back({CampaignState::waiting, fs::exists(campaign / "ledger.jsonl")
                                                    ? "it was interrupted"
                                                    : "it was never run"});
    else if (job->second > signalled)
      states.push_back({CampaignState::waiting, "it was stopped"});
    else if (job->second != 0)
      states.push_back(
          {CampaignState::failed, fmt::format("it failed with exit code {}", job->second)});
    else if (!fs::exists(summary_of(campaign)))
      states.push_back({CampaignState::waiting, "its results are gone"});
    else if (goes_on(campaign))
      states.push_back({CampaignState::waiting, "it was begun anew and interrupted"});
    else
      states.push_back({CampaignState::done, "it is done"});
  }
  return states;
}

JobShare job_share(int cores, int asked_jobs, int ranks_of_case) {
  if (ranks_of_case > 0) {
    const int most = std::max(1, cores / ranks_of_case);
    return {asked_jobs > 0 ? std::min(asked_jobs, most) : most, ranks_of_case};
  }
  const int jobs = asked_jobs > 0 ? std::min(asked_jobs, cores) : cores;
  return {jobs, std::max(1, cores / jobs)};
}

int run_campaigns(const StudyFolder& folder, const StudyPlan& plan,
                  const std::vector<fs::path>& all, const StudyRun& how, Progress& progress) {
  Course course{to_run(plan, all, states_of(folder, all), how), {}, 0, 0};
  course.done = all.size() - course.waiting.size();
  auto looked = Clock::now();
  progress.begin("study", 0.0, 1.0);
  while (!course.waiting.empty() || !course.running.empty()) {
    stop_if_interrupted();
    while (!course.waiting.empty() && course.running.size() < static_cast<std::size_t>(how.jobs)) {
      course.running.push_back(started(course.waiting.front(), all[course.waiting.front()], how));
      course.waiting.pop_front();
    }
    take_ended(folder, all, how, course, progress);
    if (Clock::now() - looked > between_shares) {
      looked = Clock::now();
      show(course, all, progress);
    }
    std::this_thread::sleep_for(between_looks);
  }
  progress.end();
  return course.failed;
}

}  // namespace millwear::orchestrator
