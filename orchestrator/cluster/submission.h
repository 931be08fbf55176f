#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/cluster/slurm.h"
#include "orchestrator/cluster/slurm_settings.h"

namespace millwear::orchestrator {

/// How a job is submitted.
struct Submission {
  SlurmSettings settings;
  std::optional<std::filesystem::path> batch_template{};  ///< instead of the program's own
  enum class Action { submit, test } action = Action::submit;
};

/// Work for a batch job, in a folder that keeps its script and what it prints.
struct BatchWork {
  std::string name;
  std::filesystem::path folder;
  std::vector<std::string> command;  ///< words, of which some may be shell: "$(...)"
  int cores;
  double seconds;        ///< likely to be needed
  double chunk_seconds;  ///< likely to be needed between two stops that cost nothing
  double memory;         ///< [bytes]
};

/// Memory that a campaign's DEM is likely to need, with room to spare [bytes].
[[nodiscard]] double memory_for(const Case& mill, int ranks);

/// Writes `FOLDER/NAME.sh` and submits it; returns the job's number. With Action::test it prints
/// the script and what sbatch says of it instead, and returns "". Throws InputError for a template
/// that is none, and for a walltime in which no chunk of the work can end; DiskError,
/// ExternalProgramError.
[[nodiscard]] std::string submit_work(const BatchWork& work, const Submission& how,
                                      const std::optional<JobArray>& array,
                                      const std::vector<std::string>& after);

}  // namespace millwear::orchestrator
