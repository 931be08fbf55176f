#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/app/common_options.h"
#include "orchestrator/app/slurm_options.h"
#include "orchestrator/study/run_campaigns.h"

namespace millwear::orchestrator {

/// What `millwear study` is told.
struct StudyOptions {
  CommonOptions common;           ///< its file is a study, or with `axes` a case
  std::vector<std::string> axes;  ///< KEY=VALUE,VALUE or KEY=LOW:HIGH:STEP
  std::optional<std::string> objective;
  std::optional<int> replicates;
  std::filesystem::path out;  ///< empty: studies/NAME
  bool charge_from_base = false;
  int jobs = 0;  ///< 0: as many as there are cores
  std::size_t most_points = 1000;
  OnFail on_fail = OnFail::go_on;
  bool retry_failed = false;
  bool dry_run = false;
  bool explain = false;
  SlurmOptions slurm;
  std::optional<int> bundle;      ///< campaigns of a task
  std::vector<std::string> only;  ///< names of folders: run these campaigns and gather nothing
  bool only_charge = false;       ///< mix the base case's charge and no more
  std::optional<std::filesystem::path> scratch;  ///< as `millwear run` takes it
  bool gather = false;  ///< write tables and page of what there is, and run nothing
};

void add_options(CLI::App& verb, StudyOptions& options);

/// Runs what is missing of a study and writes its tables and its page.
void study_verb(const StudyOptions& options);

}  // namespace millwear::orchestrator
