#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace millwear::orchestrator {

/// A job as a batch script describes it.
struct BatchJob {
  std::string name;
  std::string log;  ///< where it prints to, with the scheduler's own placeholders
  int tasks;        ///< of an array; 1 where it is none
  int cores;
  double hours;                      ///< walltime
  double memory;                     ///< [bytes]
  std::vector<std::string> options;  ///< lines of the scheduler's own, such as "#SBATCH -A mine"
  std::string setup;                 ///< lines of shell before the work, such as modules to load
  std::string command;               ///< of shell
  int signal_seconds;                ///< a warning comes so long before the walltime is up
  int most_restarts;
};

/// The template for Slurm that comes with the program.
[[nodiscard]] std::string_view slurm_template();

/// A template with {{name}}, {{log}}, {{tasks}}, {{cores}}, {{time}} (hours:minutes:seconds),
/// {{memory_mb}},
/// {{options}}, {{setup}}, {{command}}, {{signal_seconds}} and {{most_restarts}} filled in; a
/// template may leave out any but {{command}}. `file` stands in messages. Throws InputError
/// (file:line) for another placeholder, and where {{command}} is missing.
[[nodiscard]] std::string batch_script(std::string_view text, const std::string& file,
                                       const BatchJob& job);

}  // namespace millwear::orchestrator
