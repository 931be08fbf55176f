#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "orchestrator/dem_run/progress.h"
#include "orchestrator/study/study_folder.h"
#include "orchestrator/study/study_points.h"

namespace millwear::orchestrator {

/// What becomes of the other campaigns once one has failed.
enum class OnFail { go_on, stop };

/// Whether campaigns that failed before are tried again.
enum class Failed { leave, retry };

/// How the campaigns of a study are run.
struct StudyRun {
  int jobs;   ///< campaigns side by side
  int ranks;  ///< of each whose case says none
  OnFail on_fail = OnFail::go_on;
  Failed failed = Failed::leave;
  /// What runs the campaign whose case lies in a folder, on so many ranks.
  std::function<std::vector<std::string>(const std::filesystem::path& folder, int ranks)> command;
  std::vector<std::string> only{};  ///< names of folders; empty: all campaigns
};

/// Where a campaign of a study stands.
enum class CampaignState { done, failed, waiting };

/// "it is done", "it failed with exit code 4", ...
struct StateOfCampaign {
  CampaignState state;
  std::string why;
};

/// By the job log and by the results that lie in the folders.
[[nodiscard]] std::vector<StateOfCampaign> states_of(const StudyFolder& folder,
                                                     const std::vector<std::filesystem::path>& all);

/// Jobs and ranks of each on a machine of `cores`: as many jobs as are asked for (0: as many as
/// fit) but jobs times ranks never above the cores, so at least one.
struct JobShare {
  int jobs;
  int ranks;
};
[[nodiscard]] JobShare job_share(int cores, int asked_jobs, int ranks_of_case);

/// Runs what is missing, the longest first, and returns how many failed. What a campaign prints
/// goes to `run.log` in its folder, a line a campaign to the job log. Throws Interrupted; running
/// campaigns are then stopped, and the same call goes on with them.
int run_campaigns(const StudyFolder& folder, const StudyPlan& plan,
                  const std::vector<std::filesystem::path>& all, const StudyRun& how,
                  Progress& progress);

}  // namespace millwear::orchestrator
