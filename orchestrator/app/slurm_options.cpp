#include "orchestrator/app/slurm_options.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace millwear::orchestrator {

void add_options(CLI::App& verb, SlurmOptions& options) {
  verb.add_flag("--slurm", options.submit, "Submit the work to Slurm and return");
  verb.add_flag("--slurm-dry-run", options.test,
                "Print the batch script and what sbatch says of it, and submit nothing");
  verb.add_option("--sbatch", options.sbatch,
                  "Options for sbatch, such as \"--partition=long --account=mine\"");
  verb.add_option("--submit-template", options.batch_template,
                  "Template of the batch script, instead of the program's own (docs/cluster.md)");
}

Submission submission_from(const SlurmOptions& options, SlurmSettings settings) {
  for (auto& option : sbatch_options(options.sbatch)) settings.options.push_back(std::move(option));
  return {std::move(settings), options.batch_template,
          options.test ? Submission::Action::test : Submission::Action::submit};
}

}  // namespace millwear::orchestrator
