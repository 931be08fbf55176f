#include "orchestrator/stages/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"

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

Outcome work_of(const Campaign& campaign, const StageId& stage, const fs::path& into,
                Progress& progress) {
  switch (stage.kind) {
    case StageKind::mesh:
      mesh_stage(campaign, stage.cycle, into);
      return Outcome::go_on;
    case StageKind::mix:
      mix_stage(campaign, stage.cycle, into, progress);
      return Outcome::go_on;
    case StageKind::tune:
      tune_stage(campaign, into, progress);
      return Outcome::go_on;
    case StageKind::dem:
      dem_stage(campaign, stage.cycle, into, progress);
      return Outcome::go_on;
    case StageKind::wear:
      return wear_stage(campaign, stage.cycle, into);
  }
  throw std::logic_error("a stage of no kind");
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem)
    throw DiskError(fmt::format("{}: no folder can be made here ({}); give another with --out",
                                folder.string(), problem.message()));
}

LinerProfile liner_of_cycle(const Campaign& campaign, int cycle) {
  if (cycle == 0) return campaign.mill.liner;
  const auto folder = campaign.folder.stage({cycle - 1, StageKind::wear});
  const auto kept = read_cycle(folder / stage_files::steps, campaign.mill.liner.sector);
  const bool was_worn_out_before = kept.steps.empty();
  return was_worn_out_before ? liner_of_cycle(campaign, cycle - 1) : kept.steps.back().profile;
}

Rotation rotation_of_cycle(const Campaign& campaign, int cycle) {
  const auto& times = campaign.mill.campaign.reversal_times;
  if (times.empty()) return Rotation::as_new;
  return rotation_after(times, milling_time_before(campaign, cycle));
}

LinerProfile dem_liner_of_cycle(const Campaign& campaign, int cycle) {
  return as_turned(liner_of_cycle(campaign, cycle), rotation_of_cycle(campaign, cycle));
}

int first_cycle_of_rotation(const Campaign& campaign, int cycle) {
  const auto& times = campaign.mill.campaign.reversal_times;
  if (times.empty()) return 0;
  const auto reversals_before = [&](int of) {
    return reversals_by(times, milling_time_before(campaign, of));
  };
  int first = cycle;
  while (first > 0 && reversals_before(first - 1) == reversals_before(cycle)) --first;
  return first;
}

double milling_time_before(const Campaign& campaign, int cycle) {
  double time = 0.0;
  for (int i = 0; i < cycle; ++i) {
    const auto folder = campaign.folder.stage({i, StageKind::wear});
    for (const auto& step :
         read_cycle(folder / stage_files::steps, campaign.mill.liner.sector).steps)
      time += step.duration;
  }
  return time;
}

wear::TimedLoad timed_load(const Campaign& campaign, int cycle, double time,
                           const wear::LoadRate& rate) {
  return {time, dem_liner_of_cycle(campaign, cycle), rate.smoothed.rate, rate.by_block};
}

double share_of_life(const Case& mill, const LinerProfile& liner) {
  const auto gone = [](double now, double fresh, double limit) {
    return fresh > limit ? (fresh - now) / (fresh - limit) : 1.0;
  };
  return std::clamp(
      std::max(
          gone(lifter_height(liner), lifter_height(mill.liner), mill.campaign.height_limit),
          gone(plate_thickness(liner), plate_thickness(mill.liner), mill.campaign.plate_limit)),
      0.0, 1.0);
}

LedgerEntry run_stage(const Campaign& campaign, const StageId& stage, Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  const fs::path partial = campaign.folder.partial_stage(stage);
  const fs::path final_folder = campaign.folder.stage(stage);
  fs::remove_all(partial);
  fs::remove_all(final_folder);
  make_folder(partial);

  const Outcome outcome = work_of(campaign, stage, partial, progress);
  const auto outputs = synced_outputs(partial);
  sync_path(partial);
  fs::rename(partial, final_folder);
  sync_path(final_folder.parent_path());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
  return {stage, outcome, outputs, taken.count()};
}

}  // namespace millwear::orchestrator
