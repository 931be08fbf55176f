#include "orchestrator/dem_run/mixing.h"

#include <fmt/format.h>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/whole_file.h"
#include "mill/case/time_step.h"
#include "mill/load/drift_text.h"
#include "mill/recording/recorder_lines.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

std::vector<std::string> mixing_arguments(const Case& mill, int ranks) {
  return to_arguments(MixingOptions{.deck = liggghts::file_names::deck,
                                    .record = stage_files::mixing,
                                    .plan = mixing_plan(mill, plan_steps(mill)),
                                    .columns = liggghts::columns_to_balance(mill, ranks)});
}

MixingRecord read_mixing(const Case& mill, const std::filesystem::path& folder) {
  const auto file = folder / stage_files::mixing;
  return mixing_from_csv(read_file(file), file, mixing_plan(mill, plan_steps(mill)));
}

std::function<void(std::string_view)> drift_follower(const std::string& stage, Progress& progress) {
  return [stage, &progress](std::string_view line) {
    if (const auto told = mixing_line(line))
      progress.rename(fmt::format("{}, {}", stage, spoken_torque_drift(told->drift)));
  };
}

}  // namespace millwear::orchestrator
