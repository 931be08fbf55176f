#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear run` is told.
struct RunOptions {
  CommonOptions common;
  std::filesystem::path out;  ///< empty: runs/NAME
  std::optional<int> ranks;   ///< instead of the case's
  bool dry_run = false;       ///< say what would run, and run nothing
  bool explain = false;       ///< say why each stage runs
};

void add_options(CLI::App& verb, RunOptions& options);

/// Runs the campaign to its end, from wherever it stands.
void run_verb(const RunOptions& options);

}  // namespace millwear::orchestrator
