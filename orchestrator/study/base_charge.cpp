#include "orchestrator/study/base_charge.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <thread>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/process/logged_child.h"

namespace millwear::orchestrator {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(200);

}  // namespace

bool has_base_charge(const StudyFolder& folder) {
  return std::filesystem::exists(RunFolder{folder.base_charge()}.stage({0, StageKind::mix}));
}

void mix_base_charge(const StudyFolder& folder, const std::vector<std::string>& command,
                     Progress& progress) {
  if (has_base_charge(folder)) return;
  const RunFolder campaign{folder.base_charge()};
  make_folder(campaign.root);
  const auto log = campaign.root / "run.log";
  progress.begin("mixing the base case's charge", 0.0, 0.0);
  const auto process = start_logged(command, log);
  std::optional<int> code;
  while (!(code = process->ended())) {
    stop_if_interrupted();
    std::this_thread::sleep_for(between_looks);
  }
  progress.end();
  if (*code != 0)
    throw ExternalProgramError(fmt::format(
        "the base case could not be mixed (exit code {}); see {}", *code, log.string()));
}

}  // namespace millwear::orchestrator
