#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"
#include "orchestrator/app/slurm_options.h"
#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// What `millwear run` is told.
struct RunOptions {
  CommonOptions common;
  std::filesystem::path out;                     ///< empty: runs/NAME
  std::optional<int> ranks;                      ///< instead of the case's
  std::optional<std::uint64_t> seed;             ///< likewise
  std::optional<std::filesystem::path> shared;   ///< folder of shared DEM
  std::optional<std::filesystem::path> scratch;  ///< folder in which the DEM's files grow
  std::optional<std::string> until;              ///< run no further than this stage, "3:dem"
  bool dry_run = false;                          ///< say what would run, and run nothing
  bool explain = false;                          ///< say why each stage runs
  SlurmOptions slurm;
};

void add_options(CLI::App& verb, RunOptions& options);

/// Runs the campaign to its end, from wherever it stands.
void run_verb(const RunOptions& options);

}  // namespace millwear::orchestrator
