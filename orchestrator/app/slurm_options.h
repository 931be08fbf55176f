#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "orchestrator/cluster/submission.h"

namespace CLI {
class App;
}

namespace millwear::orchestrator {

/// What `run` and `study` are told of a cluster.
struct SlurmOptions {
  bool submit = false;
  bool test = false;
  std::string sbatch;
  std::optional<std::filesystem::path> batch_template;
  /// Whether the work is to be submitted, or only shown.
  [[nodiscard]] bool asked() const { return submit || test; }
};

void add_options(CLI::App& verb, SlurmOptions& options);

/// With the settings that a study file gives, and the command line's after them.
[[nodiscard]] Submission submission_from(const SlurmOptions& options, SlurmSettings settings);

}  // namespace millwear::orchestrator
