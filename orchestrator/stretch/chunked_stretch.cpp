#include "orchestrator/stretch/chunked_stretch.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/torque_series.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/stretch/chunk_run.h"
#include "orchestrator/stretch/step_follower.h"
#include "orchestrator/stretch/stretch_checks.h"
#include "orchestrator/stretch/stretch_decks.h"
#include "wear/charge/charge_record.h"
#include "wear/rate/load_rate.h"
#include "wear/record/collision_store.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;
using liggghts::Chunk;
using liggghts::StretchSteps;

/// How a chunk is run, and where in its stage it stands.
struct ChunkToRun {
  const Campaign& campaign;
  StageId stage;
  const Chunk& chunk;
  std::size_t count;  ///< of chunks as far as they are planned
  RecorderProgram program;
  fs::path restart_before;  ///< none where it packs its charge
};

/// What decides the chunk's result beside its decks.
std::string surroundings(const ChunkToRun& run) {
  const RunFolder& folder = run.campaign.folder;
  std::string text = fmt::format("{} {}", program_version(), run.campaign.ranks);
  for (const auto& word : run.program.arguments) text += " " + word;
  std::vector<fs::path> files = {
      folder.locked_case(), folder.stage({run.stage.cycle, StageKind::mesh}) / stage_files::mesh};
  if (!run.restart_before.empty()) files.push_back(run.restart_before);
  for (const auto& file : files) text += "\n" + hash_of_file(file);
  return text;
}

void run_with(const ChunkToRun& run, const std::function<void(const fs::path&)>& write_inputs,
              Progress& progress) {
  const Campaign& campaign = run.campaign;
  const auto number = static_cast<double>(run.chunk.number);
  const auto count = static_cast<double>(run.count);
  const std::string name =
      fmt::format("{}, chunk {} of {}", name_of(run.stage), run.chunk.number + 1, run.count);
  const auto simulate = [&](const fs::path& into) {
    progress.rename(name);
    run_liggghts(
        {into, campaign.ranks,
         step_follower(name, run.chunk.steps, progress, {number / count, (number + 1.0) / count}),
         run.program, campaign.mill.dem.launcher},
        {});
    check_stretch(campaign.mill, run.chunk.steps,
                  mesh_of_cycle(campaign, run.stage.cycle).triangles, into);
    if (run.stage.kind == StageKind::dem) check_recorded(campaign.mill, into);
  };
  run_chunk(campaign, {chunk_folder(campaign, run.stage, run.chunk.number), surroundings(run),
                       write_inputs, simulate});
  progress.advance((number + 1.0) / count);
}

void keep_decks_and_log(const fs::path& chunk, int number, const fs::path& into) {
  for (const char* const name : {names::deck, names::contact_model, names::log}) {
    const fs::path file(name);
    fs::copy_file(chunk / file, into / fmt::format("{}_{}{}", file.stem().string(), number,
                                                   file.extension().string()));
  }
}

/// The torques of a chunk at the steps of the whole stretch, as LIGGGHTS writes them.
std::string torques(const fs::path& chunk_folder, const Chunk& chunk, const StretchSteps& stretch) {
  const fs::path file = chunk_folder / names::torque;
  std::string lines;
  for (const auto& value : liggghts::read_torque_series(read_file(file), file.string()))
    lines += fmt::format(
        "{} {}\n",
        value.step - chunk.steps.settle_steps + chunk.measured_before + stretch.settle_steps,
        value.torque);
  return lines;
}

void join_collisions(const std::vector<fs::path>& chunks, const fs::path& into) {
  constexpr std::size_t block_size = 8192;
  wear::CollisionWriter writer(into / stage_files::events);
  std::vector<wear::Collision> block;
  const auto flush = [&] {
    writer.append(block);
    block.clear();
  };
  for (const auto& chunk : chunks) {
    wear::for_each_collision(chunk / stage_files::events, [&](const wear::Collision& collision) {
      // A block that ends between two of one time could not be put in order.
      if (block.size() >= block_size && collision.end > block.back().end) flush();
      block.push_back(collision);
    });
  }
  flush();
  writer.close();
}

/// How well the load is known, where that is asked for.
std::optional<wear::MeasurementGoal> goal_of(const Case& mill, const LinerProfile& liner,
                                             const WallLoad& load) {
  if (!mill.dem.error_target) return std::nullopt;
  return wear::MeasurementGoal{
      mill.dem.error_target->relative_error,
      wear::peak_error_of_load(mill.wear, mill.charge.classes, liner, load)};
}

bool goes_on(const std::optional<wear::MeasurementGoal>& goal, const StretchSteps& stretch,
             const Chunk& last) {
  const long measured = last.measured_before + last.steps.measure_steps;
  return goal && !wear::is_reached(*goal) &&
         measured + stretch.go_on_steps <= stretch.most_measure_steps;
}

}  // namespace

void mix_in_chunks(const Campaign& campaign, int cycle, const std::vector<Chunk>& chunks,
                   const fs::path& into, Progress& progress) {
  const StageId stage{cycle, StageKind::mix};
  const auto program = unrecorded_program(campaign.mill, campaign.ranks);
  fs::path before;
  for (const Chunk& chunk : chunks) {
    run_with(
        {campaign, stage, chunk, chunks.size(), program.value(), before},
        [&](const fs::path& folder) {
          const auto words = write_mixing_deck(campaign, cycle, chunk, folder);
          if (!words.empty()) progress.say(fmt::format("cycle {}: {}", cycle, words));
        },
        progress);
    const fs::path folder = chunk_folder(campaign, stage, chunk.number);
    keep_decks_and_log(folder, chunk.number, into);
    before = folder / names::restart;
  }
  fs::copy_file(chunk_folder(campaign, stage, 0) / names::charge, into / names::charge);
  fs::copy_file(before, into / names::restart);
}

void record_in_chunks(const Campaign& campaign, int cycle, const StretchSteps& stretch,
                      const std::vector<Chunk>& chunks, const fs::path& into, Progress& progress) {
  const StageId stage{cycle, StageKind::dem};
  const Case& mill = campaign.mill;
  const LinerProfile liner = dem_liner_of_cycle(campaign, cycle);
  const StepPlan plan = plan_steps(mill);
  std::optional<wear::LinerRecord> record;
  std::optional<wear::ChargeRecord> charge;
  std::string torque_lines = "# step, torque on the liner about +y [N m]\n";
  std::vector<fs::path> folders;
  std::vector<Chunk> planned = chunks;
  fs::path before = restart_before_stretch(campaign, cycle);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const Chunk chunk = planned[i];
    run_with(
        {campaign, stage, chunk, planned.size(),
         RecorderProgram{recorder_program(),
                         recorder_arguments(mill, campaign.ranks, stretch, chunk)},
         before},
        [&](const fs::path& folder) { write_measuring_deck(campaign, cycle, chunk, folder); },
        progress);
    folders.push_back(chunk_folder(campaign, stage, chunk.number));
    keep_decks_and_log(folders.back(), chunk.number, into);
    torque_lines += torques(folders.back(), chunk, stretch);
    before = folders.back() / names::restart;
    auto part = wear::read_record(folders.back() / stage_files::load);
    record = record ? wear::joined(*record, part) : std::move(part);
    auto look = wear::read_charge(folders.back() / stage_files::charge);
    charge = charge ? wear::joined(std::move(*charge), look) : std::move(look);
    if (i + 1 < planned.size()) continue;
    record->goal = goal_of(mill, liner, record->load);
    if (goes_on(record->goal, stretch, chunk))
      planned.push_back(liggghts::chunk_after(chunk, stretch, plan));
  }
  if (mill.dem.keep_events) join_collisions(folders, into);
  write_file(into / names::torque, torque_lines);
  wear::write_record(into / stage_files::load, *record);
  wear::write_charge(into / stage_files::charge, *charge);
  fs::copy_file(before, into / names::restart);
}

}  // namespace millwear::orchestrator
