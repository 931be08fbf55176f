#include "orchestrator/cluster/study_jobs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/study/base_charge.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

fs::path slurm_folder(const StudyFolder& folder) { return folder.root / "slurm"; }
fs::path job_list(const StudyFolder& folder) { return slurm_folder(folder) / "jobs.tsv"; }

/// The campaigns of each task of an array, a line a task.
std::vector<std::vector<std::string>> tasks_in(const fs::path& index) {
  std::vector<std::vector<std::string>> tasks;
  std::istringstream lines(fs::exists(index) ? read_file(index) : "");
  for (std::string line; std::getline(lines, line);) {
    auto& campaigns = tasks.emplace_back();
    std::istringstream names(line);
    for (std::string name; std::getline(names, name, ',');) campaigns.push_back(name);
  }
  return tasks;
}

/// The jobs that were submitted, with their index files: lines "JOB<tab>INDEX".
std::vector<std::pair<std::string, fs::path>> jobs_in(const StudyFolder& folder) {
  std::vector<std::pair<std::string, fs::path>> jobs;
  const fs::path list = job_list(folder);
  std::istringstream lines(fs::exists(list) ? read_file(list) : "");
  std::string job;
  std::string index;
  while (lines >> job >> index) jobs.emplace_back(job, slurm_folder(folder) / index);
  return jobs;
}

/// The names of the campaigns that are to be submitted, the dearest first.
std::vector<std::string> missing_campaigns(const StudyToSubmit& study) {
  const auto queued = queued_campaigns(study.folder);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < study.campaigns.size(); ++i)
    if (study.states[i].state == CampaignState::waiting &&
        !queued.contains(study.campaigns[i].filename().string()))
      missing.push_back(i);
  std::ranges::stable_sort(missing, std::greater<>(),
                           [&](std::size_t i) { return study.plan.campaigns[i].cost; });
  std::vector<std::string> names;
  for (const std::size_t i : missing) names.push_back(study.campaigns[i].filename().string());
  return names;
}

/// What the dearest campaign of a study, and its longest chunk, are likely to take [s].
struct DearestCampaign {
  double seconds = 0.0;
  double chunk_seconds = 0.0;
};

DearestCampaign dearest_of(const StudyToSubmit& study) {
  DearestCampaign dearest;
  for (const StudyCampaign& campaign : study.plan.campaigns) {
    dearest.seconds = std::max(dearest.seconds, campaign.cost / study.ranks);
    dearest.chunk_seconds = std::max(dearest.chunk_seconds, campaign.chunk_cost / study.ranks);
  }
  return dearest;
}

std::vector<std::string> with(std::vector<std::string> words, std::vector<std::string> more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

std::map<std::string, std::string> queued_campaigns(const StudyFolder& folder) {
  const auto jobs = jobs_in(folder);
  std::vector<std::string> numbers;
  for (const auto& [job, index] : jobs) numbers.push_back(job);
  const auto states = job_states(numbers);
  std::map<std::string, std::string> queued;
  for (const auto& [job, index] : jobs) {
    const auto tasks = tasks_in(index);
    for (std::size_t task = 0; task < tasks.size(); ++task)
      if (const auto state = states.find(fmt::format("{}_{}", job, task)); state != states.end())
        for (const auto& campaign : tasks[task]) queued[campaign] = state->second;
  }
  return queued;
}

SubmittedStudy submit_study(const StudyToSubmit& study, const Submission& how) {
  const auto missing = missing_campaigns(study);
  SubmittedStudy submitted{missing.size(), {}, ""};
  if (missing.empty()) return submitted;
  const fs::path folder = slurm_folder(study.folder);
  const double memory = memory_for(study.plan.base, study.ranks);
  const DearestCampaign dearest = dearest_of(study);
  const bool is_test = how.action == Submission::Action::test;
  if (!is_test) make_folder(folder);

  std::vector<std::string> first;
  if (study.plan.study.charge_from_base && !has_base_charge(study.folder))
    first = {submit_work({"charge", folder, with(study.command, {"--only-charge"}), study.ranks,
                          dearest.seconds, dearest.chunk_seconds, memory},
                         how, std::nullopt, {})};

  const auto bundle = static_cast<std::size_t>(how.settings.bundle);
  const auto tasks_of_array = static_cast<std::size_t>(most_array_tasks());
  std::string jobs = fs::exists(job_list(study.folder)) ? read_file(job_list(study.folder)) : "";
  std::size_t number = jobs_in(study.folder).size();
  for (std::size_t begin = 0; begin < missing.size(); begin += bundle * tasks_of_array, ++number) {
    const std::size_t end = std::min(missing.size(), begin + bundle * tasks_of_array);
    std::string index;
    int tasks = 0;
    for (std::size_t i = begin; i < end; i += bundle, ++tasks)
      index += fmt::format(
          "{}\n",
          fmt::join(missing.begin() + static_cast<std::ptrdiff_t>(i),
                    missing.begin() + static_cast<std::ptrdiff_t>(std::min(end, i + bundle)), ","));
    const std::string name = fmt::format("points_{}", number);
    if (!is_test) publish(folder / (name + ".index"), index);
    const std::string campaigns = fmt::format("$(sed -n $((SLURM_ARRAY_TASK_ID + 1))p '{}')",
                                              fs::absolute(folder / (name + ".index")).string());
    const auto job = submit_work(
        {name, folder, with(study.command, {"--only", campaigns, "--jobs", "1", "--quiet"}),
         study.ranks, dearest.seconds * static_cast<double>(bundle), dearest.chunk_seconds, memory},
        how, JobArray{tasks, how.settings.throttle}, first);
    if (job.empty()) continue;
    submitted.arrays.push_back(job);
    jobs += fmt::format("{}\t{}.index\n", job, name);
    publish(job_list(study.folder), jobs);
  }
  submitted.gathering = submit_work({"gather", folder, with(study.command, {"--gather", "--quiet"}),
                                     1, 600.0, 0.0, memory_for(study.plan.base, 1)},
                                    how, std::nullopt, submitted.arrays);
  return submitted;
}

}  // namespace millwear::orchestrator
