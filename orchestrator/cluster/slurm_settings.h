#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear::orchestrator {

/// How jobs are submitted: the `[slurm]` table of a study file, and what the command line adds.
struct SlurmSettings {
  std::optional<double> hours{};       ///< walltime; by default from the cost
  std::optional<double> memory{};      ///< [bytes]; by default from the particles
  std::vector<std::string> options{};  ///< of sbatch, such as "--partition=long"
  std::vector<std::string> modules{};  ///< to be loaded before the work
  int throttle = 0;                    ///< at most so many tasks of an array at once; 0: no limit
  int bundle = 1;                      ///< campaigns that one task runs, one after the other
  int signal_seconds = 300;            ///< a warning comes so long before the walltime is up
  int most_restarts = 20;              ///< of a job that Slurm's walltime has stopped
};

/// Reads the table `[slurm]`; the defaults where there is none. Adds what is wrong to `problems`.
[[nodiscard]] SlurmSettings slurm_settings_in(const CaseDocument& document, CaseProblems& problems);

/// The same of a study file. Throws InputError with all that is wrong.
[[nodiscard]] SlurmSettings slurm_settings_of(const std::filesystem::path& study_file);

/// The words of `--sbatch "..."`, each an option of sbatch. Throws Failure (usage) for a word that
/// is none.
[[nodiscard]] std::vector<std::string> sbatch_options(const std::string& words);

/// "1-12:30:00", "12:30:00", "45" (minutes) and what else sbatch takes as a time, in hours. None
/// for anything else.
[[nodiscard]] std::optional<double> walltime_hours(const std::string& text);

}  // namespace millwear::orchestrator
