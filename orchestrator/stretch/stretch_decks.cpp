#include "orchestrator/stretch/stretch_decks.h"

#include <fmt/format.h>

#include "liggghts_inputs/decks/charge_data.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/dem_run/charge_source.h"
#include "orchestrator/dem_run/tune_stage.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

const char* const mesh_from_stage = "../mesh/liner.stl";
const char* const profile_from_stage = "../mesh/profile.csv";
const char* const locked_case_from_stage = "../../case.lock.toml";
/// The mill as it is operated in the stage, where that changes in the campaign.
const char* const operated_case = "case_as_operated.toml";

const char* case_from_stage(const Case& mill) {
  return mill.campaign.operation.empty() ? locked_case_from_stage : operated_case;
}

std::string name_of_chunk(StageKind kind, int chunk) {
  return fmt::format(".{}.chunk_{}", name_of(kind), chunk);
}

/// The stage whose charge the measurement of a cycle begins with.
StageId stage_before(const Campaign& campaign, int cycle) {
  const bool is_mixed_anew = first_cycle_of_operation(campaign, cycle) == cycle;
  return is_mixed_anew ? StageId{cycle, StageKind::mix} : StageId{cycle - 1, StageKind::dem};
}

std::string restart_before(const Campaign& campaign, int cycle, const liggghts::Chunk& chunk) {
  if (chunk.number > 0)
    return fmt::format("../{}/{}", name_of_chunk(StageKind::dem, chunk.number - 1), names::restart);
  const StageId stage = stage_before(campaign, cycle);
  return stage.kind == StageKind::mix
             ? fmt::format("../mix/{}", names::restart)
             : fmt::format("../../cycle_{:03}/dem/{}", stage.cycle, names::restart);
}

RecordingPlan recording_plan(const Case& mill, int ranks, const liggghts::StretchSteps& steps) {
  RecordingPlan plan{.deck = names::deck,
                     .mill = case_from_stage(mill),
                     .liner = profile_from_stage,
                     .load = stage_files::load,
                     .events = {},
                     .charge = stage_files::charge,
                     .first_step = steps.settle_steps,
                     .last_step = steps.total(),
                     .every_steps = steps.sample_steps,
                     .pairs_after = {},
                     .going_on = {}};
  if (mill.dem.keep_events) plan.events = stage_files::events;
  plan.columns = liggghts::columns_to_balance(mill, ranks);
  if (steps.pair_steps > 0) plan.pairs_after = steps.total() - steps.pair_steps;
  return plan;
}

}  // namespace

fs::path chunk_folder(const Campaign& campaign, const StageId& stage, int chunk) {
  return campaign.folder.stage(stage).parent_path() / name_of_chunk(stage.kind, chunk);
}

fs::path restart_before_stretch(const Campaign& campaign, int cycle) {
  return campaign.folder.stage(stage_before(campaign, cycle)) / names::restart;
}

liggghts::LinerMeshFile mesh_of_cycle(const Campaign& campaign, int cycle) {
  return {mesh_from_stage, triangles_of_mesh(campaign.folder.stage({cycle, StageKind::mesh}))};
}

std::string write_mixing_deck(const Campaign& campaign, int cycle, const liggghts::Chunk& chunk,
                              const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::mix});
  std::optional<std::string> restart;
  std::string words;
  if (chunk.number > 0) {
    restart =
        fmt::format("../{}/{}", name_of_chunk(StageKind::mix, chunk.number - 1), names::restart);
  } else {
    const FirstCharge charge = first_charge(campaign, cycle, into);
    write_file(into / names::charge, liggghts::charge_data_file(mill, charge.particles));
    words = charge.words;
  }
  write_file(into / names::deck, liggghts::mixing_deck(mill, chunk.steps, restart, campaign.ranks));
  write_file(into / names::contact_model,
             liggghts::contact_model_deck(mill, chunk.steps, mesh_of_cycle(campaign, cycle),
                                          {liggghts::StretchKind::mix, cycle, chunk.number}));
  return words;
}

void write_measuring_deck(const Campaign& campaign, int cycle, const liggghts::Chunk& chunk,
                          const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::dem});
  if (!mill.campaign.operation.empty()) {
    Case operated = mill;
    operated.campaign.operation.clear();
    write_file(into / operated_case, locked_case_text(operated));
  }
  write_file(into / names::deck,
             liggghts::measuring_deck(mill, chunk.steps, dem_liner_of_cycle(campaign, cycle),
                                      restart_before(campaign, cycle, chunk), campaign.ranks));
  write_file(into / names::contact_model,
             liggghts::contact_model_deck(mill, chunk.steps, mesh_of_cycle(campaign, cycle),
                                          {liggghts::StretchKind::measure, cycle, chunk.number}));
}

std::string write_mixing_deck(const Campaign& campaign, int cycle, const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::mix});
  return write_mixing_deck(campaign, cycle, {0, liggghts::mixing_steps(mill, plan_steps(mill))},
                           into);
}

void write_measuring_deck(const Campaign& campaign, int cycle, const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::dem});
  write_measuring_deck(campaign, cycle, {0, liggghts::measuring_steps(mill, plan_steps(mill))},
                       into);
}

std::vector<std::string> recorder_arguments(const Case& mill, int ranks) {
  const auto steps = liggghts::measuring_steps(mill, plan_steps(mill));
  RecordingPlan plan = recording_plan(mill, ranks, steps);
  if (mill.dem.error_target)
    plan.going_on = GoingOn{mill.dem.error_target->relative_error, steps.go_on_steps,
                            steps.settle_steps + steps.most_measure_steps};
  return to_arguments(plan);
}

std::vector<std::string> recorder_arguments(const Case& mill, int ranks,
                                            const liggghts::StretchSteps& stretch,
                                            const liggghts::Chunk& chunk) {
  RecordingPlan plan = recording_plan(mill, ranks, chunk.steps);
  plan.measured_before = chunk.measured_before;
  plan.block_steps = stretch.measure_steps;
  return to_arguments(plan);
}

}  // namespace millwear::orchestrator
