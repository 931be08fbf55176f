#include "orchestrator/stages/run_stage.h"

#include <fmt/format.h>

#include <chrono>
#include <functional>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/work_folder.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "orchestrator/stages/mesh_stage.h"
#include "orchestrator/stages/shared_stages.h"
#include "orchestrator/stages/wear_stage.h"
#include "orchestrator/stretch/chunk_run.h"
#include "orchestrator/stretch/stretch_stages.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> synced_outputs(const fs::path& folder) {
  std::map<std::string, std::string> outputs;
  for (const auto& file : fs::directory_iterator(folder)) {
    sync_path(file.path());
    outputs[file.path().filename().string()] = hash_of_file(file.path());
  }
  return outputs;
}

/// Does the work, or takes what another campaign of the study has made of the same.
void shared(const Campaign& campaign, const StageId& stage, const fs::path& into,
            const std::function<void()>& work) {
  if (campaign.shared_stages)
    fill_shared(*campaign.shared_stages, hash_of_dem(campaign, stage), into, work);
  else
    work();
}

Outcome work_of(const Campaign& campaign, const StageId& stage, const fs::path& into,
                Progress& progress) {
  switch (stage.kind) {
    case StageKind::mesh:
      mesh_stage(campaign, stage.cycle, into);
      return Outcome::go_on;
    case StageKind::mix:
      shared(campaign, stage, into, [&] { mix_stage(campaign, stage.cycle, into, progress); });
      return Outcome::go_on;
    case StageKind::tune:
      tune_stage(campaign, into, progress);
      return Outcome::go_on;
    case StageKind::dem:
      shared(campaign, stage, into, [&] { simulate_load(campaign, stage.cycle, into, progress); });
      measure_load(campaign, stage.cycle, into, progress);
      return Outcome::go_on;
    case StageKind::wear:
      return wear_stage(campaign, stage.cycle, into);
  }
  throw std::logic_error("a stage of no kind");
}

}  // namespace

LedgerEntry run_stage(const Campaign& told, const StageId& stage, Progress& progress) {
  const Campaign campaign = as_operated(told, stage.cycle);
  const auto started = std::chrono::steady_clock::now();
  const fs::path partial = campaign.folder.partial_stage(stage);
  const fs::path final_folder = campaign.folder.stage(stage);
  fs::remove_all(final_folder);
  const fs::path work = begin_work(campaign, partial);
  Outcome outcome{};
  try {
    outcome = work_of(campaign, stage, work, progress);
  } catch (const Failure&) {
    end_work(work, partial);  // its log tells why
    throw;
  }
  end_work(work, partial);
  const auto outputs = synced_outputs(partial);
  sync_path(partial);
  fs::rename(partial, final_folder);
  sync_path(final_folder.parent_path());
  remove_chunks(campaign, stage);
  leave_scratch(campaign);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
  return {stage, outcome, outputs, taken.count()};
}

}  // namespace millwear::orchestrator
