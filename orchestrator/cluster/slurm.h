#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// Several tasks of one job.
struct JobArray {
  int tasks;
  int throttle;  ///< at most so many at once; 0: no limit
};

/// When a job may begin.
struct AfterJobs {
  std::vector<std::string> jobs;  ///< once all of these have ended, however they did
};

/// Submits a batch script with sbatch and returns the job's number. Throws ExternalProgramError,
/// with sbatch's own words, where it is missing or refuses.
[[nodiscard]] std::string submit(const std::filesystem::path& script,
                                 const std::optional<JobArray>& array, const AfterJobs& after);

[[nodiscard]] bool has_sbatch();

/// What sbatch says of a script's text without submitting it (--test-only). Throws as `submit`.
[[nodiscard]] std::string tested(const std::string& script, const std::optional<JobArray>& array);

/// The most tasks of one array, from the cluster's settings; 1001 where it does not tell.
[[nodiscard]] int most_array_tasks();

/// How jobs stand, by squeue: "PENDING", "RUNNING" ... of each number ("12" or "12_3") that it
/// still knows. Empty where squeue is missing.
[[nodiscard]] std::map<std::string, std::string> job_states(const std::vector<std::string>& jobs);

/// How long a job waits for a folder that is in use: the lock of a predecessor on a node that died
/// stays for up to five minutes. None outside of a job.
[[nodiscard]] std::chrono::seconds patience_of_a_job();

}  // namespace millwear::orchestrator
