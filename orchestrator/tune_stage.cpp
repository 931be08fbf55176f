#include <fmt/format.h>

#include "liggghts_inputs/deck.h"
#include "liggghts_inputs/run_summary.h"
#include "mill/failure.h"
#include "mill/time_step.h"
#include "orchestrator/mesh_facts.h"
#include "orchestrator/stages.h"
#include "orchestrator/stretch_run.h"
#include "orchestrator/tuning_file.h"
#include "orchestrator/whole_file.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

constexpr int rounds = 3;

/// The decks of the trials, run one after another in the stage's folder.
struct TrialBench {
  const Campaign& campaign;
  fs::path folder;
  liggghts::TrialSteps steps;
  liggghts::LinerMeshFile mesh;
};

TrialBench bench_for(const Campaign& campaign, const fs::path& into,
                     const liggghts::TrialSteps& steps) {
  const auto& mill = campaign.mill;
  const liggghts::LinerMeshFile mesh{
      "../mesh/liner.stl", triangles_of_mesh(campaign.folder.stage({0, StageKind::mesh}))};
  write_file(into / names::contact_model,
             liggghts::contact_model_deck(mill, {plan_steps(mill).time_step, 0, 0, 1}, mesh,
                                          liggghts::StretchKind::trial, 0));
  return {campaign, into, steps, mesh};
}

/// Runs one piece with a skin. Throws ResultRejected where LIGGGHTS does not come to its end.
void time_piece(const TrialBench& bench, SkinTrial& trial) {
  Case mill = bench.campaign.mill;
  mill.dem.skin = trial.skin;
  write_file(bench.folder / names::deck,
             liggghts::trial_deck(mill, bench.steps, fmt::format("../mix/{}", names::restart),
                                  bench.campaign.ranks));
  run_liggghts({bench.folder, bench.campaign.ranks, {}}, {});
  const fs::path log = bench.folder / names::log;
  const std::string printed = read_file(log);
  liggghts::check_stretch_log(printed, log.string(),
                              {totals(mill).particles, bench.mesh.triangles, bench.steps.total()});
  const auto runs = liggghts::read_run_summaries(printed);
  if (runs.size() != 2)
    throw ResultRejected(
        fmt::format("{}: it tells the loop time and the neighbour builds of {} runs and not of 2",
                    log.string(), runs.size()));
  add_piece(trial, runs[1].loop_seconds, runs[1].neighbour_builds,
            runs[0].dangerous_builds + runs[1].dangerous_builds);
}

void time_or_refuse(const TrialBench& bench, SkinTrial& trial) {
  try {
    time_piece(bench, trial);
  } catch (const ResultRejected& problem) {
    trial.refused = problem.what();
  }
}

std::string spoken_choice(const Tuning& tuning, const Case& mill) {
  const double untuned = liggghts::neighbour_skin(mill);
  std::string text = fmt::format("neighbour skin {:.4g} mm, {} steps a second", 1e3 * tuning.skin,
                                 spoken_speed(tuning, chosen_trial(tuning)));
  for (const auto& trial : tuning.trials)
    if (trial.skin == untuned && trial.refused.empty() && trial.skin != tuning.skin)
      text += fmt::format(" ({:.4g} mm without the trial: {})", 1e3 * untuned,
                          spoken_speed(tuning, trial));
  return text;
}

}  // namespace

void tune_stage(const Campaign& campaign, const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  const auto skins = skins_on_trial(mill);
  const auto bench = bench_for(campaign, into, trial_steps(mill, skins));
  Tuning tuning{totals(mill).particles,
                campaign.ranks,
                plan_steps(mill).time_step,
                bench.steps.timed,
                {},
                0.0};
  for (const double skin : skins) tuning.trials.push_back({.skin = skin});
  const std::size_t pieces = rounds * skins.size();
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    auto& trial = tuning.trials[piece % skins.size()];
    if (trial.refused.empty()) time_or_refuse(bench, trial);
    progress.advance(static_cast<double>(piece + 1) / static_cast<double>(pieces));
  }
  tuning.skin = chosen_skin(tuning.trials);
  for (const char* const file : {names::deck, names::contact_model, names::log})
    fs::remove(into / file);
  write_file(into / stage_files::tuning, tuning_json(tuning));
  progress.say(spoken_choice(tuning, mill));
}

Case case_of_stretch(const Campaign& campaign, const StageId& stage) {
  Case mill = campaign.mill;
  const bool is_before_the_trial = stage == StageId{0, StageKind::mix};
  if (mill.dem.tune && !is_before_the_trial)
    mill.dem.skin =
        read_tuning(campaign.folder.stage({0, StageKind::tune}) / stage_files::tuning).skin;
  return mill;
}

}  // namespace millwear::orchestrator
