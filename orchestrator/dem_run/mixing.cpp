#include "orchestrator/dem_run/mixing.h"

#include <fmt/format.h>

#include "mill/base/whole_file.h"
#include "mill/case/time_step.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

std::vector<std::string> mixing_arguments(const Case& mill) {
  const MixingPlan plan = mixing_plan(mill, plan_steps(mill));
  return {"mix",
          "--record",
          stage_files::mixing,
          "--piece",
          std::to_string(plan.piece),
          "--after",
          std::to_string(plan.left_out),
          "--at-most",
          std::to_string(plan.most),
          "--revolution",
          std::to_string(plan.revolution)};
}

MixingRecord read_mixing(const Case& mill, const std::filesystem::path& folder) {
  const auto file = folder / stage_files::mixing;
  return mixing_from_csv(read_file(file), file, mixing_plan(mill, plan_steps(mill)));
}

std::function<void(std::string_view)> drift_follower(const std::string& stage, Progress& progress) {
  return [stage, &progress](std::string_view line) {
    if (!line.starts_with("millwear: step ")) return;
    const auto words = line.substr(line.find(','));
    progress.rename(fmt::format("{}{}", stage, words.substr(0, words.find(" ("))));
  };
}

}  // namespace millwear::orchestrator
