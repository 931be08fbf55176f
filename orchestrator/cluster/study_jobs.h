#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "orchestrator/cluster/submission.h"
#include "orchestrator/study/run_campaigns.h"
#include "orchestrator/study/study_folder.h"

namespace millwear::orchestrator {

/// A study that is to be submitted.
struct StudyToSubmit {
  const StudyPlan& plan;
  StudyFolder folder;
  std::vector<std::filesystem::path> campaigns;  ///< their folders
  std::vector<StateOfCampaign> states;           ///< likewise
  std::vector<std::string> command;              ///< that runs the study here; options follow
  int ranks;                                     ///< of a campaign
};

/// How the campaigns of a study stand in the queue, by the names of their folders: "PENDING",
/// "RUNNING", ... of those that squeue knows.
[[nodiscard]] std::map<std::string, std::string> queued_campaigns(const StudyFolder& folder);

/// What was submitted.
struct SubmittedStudy {
  std::size_t campaigns = 0;        ///< that are missing and were not in the queue
  std::vector<std::string> arrays;  ///< numbers of the jobs that run them
  std::string gathering;            ///< number of the job that writes tables and page
};

/// Submits the campaigns that are neither done nor in the queue: in arrays no longer than the
/// cluster takes, `bundle` campaigns a task, each array after the charge of the base case where the
/// study wants that, and a last job that gathers. Files go to the study's folder `slurm`; an index
/// file says which campaigns a task has. Throws as `submit_work`.
SubmittedStudy submit_study(const StudyToSubmit& study, const Submission& how);

}  // namespace millwear::orchestrator
