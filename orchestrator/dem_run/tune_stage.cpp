#include "orchestrator/dem_run/tune_stage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/run_summary.h"
#include "liggghts_inputs/outputs/stretch_log.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/case/time_step.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/dem_run/tuning_file.h"

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
                                          {liggghts::StretchKind::trial, 0}));
  return {campaign, into, steps, mesh};
}

/// The mill with the settings of a trial, which is as if they had been given: nothing is left to
/// try.
Case with_settings(Case mill, const DeckSettings& settings) {
  mill.dem.tune = false;
  mill.dem.skin = settings.skin;
  mill.dem.rank_split = settings.rank_split;
  return mill;
}

/// Runs one piece with a trial's settings. Throws ResultRejected where LIGGGHTS does not come to
/// its end.
void time_piece(const TrialBench& bench, DeckTrial& trial) {
  const Case mill = with_settings(bench.campaign.mill, trial.settings);
  write_file(bench.folder / names::deck,
             liggghts::trial_deck(mill, bench.steps, fmt::format("../mix/{}", names::restart),
                                  bench.campaign.ranks));
  run_liggghts({bench.folder,
                bench.campaign.ranks,
                {},
                unrecorded_program(mill, bench.campaign.ranks),
                mill.dem.launcher},
               {});
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

void time_or_refuse(const TrialBench& bench, DeckTrial& trial) {
  try {
    time_piece(bench, trial);
  } catch (const ResultRejected& problem) {
    trial.refused = problem.what();
  }
}

/// How many of all trials' pieces are done.
struct PiecesDone {
  Progress& progress;
  std::size_t pieces;
  std::size_t done = 0;

  void one_more() {
    ++done;
    progress.advance(static_cast<double>(done) / static_cast<double>(pieces));
  }
};

std::vector<DeckTrial> timed_in_turns(const TrialBench& bench, std::vector<DeckTrial> trials,
                                      PiecesDone& pieces) {
  for (int round = 0; round < rounds; ++round)
    for (auto& trial : trials) {
      if (trial.refused.empty()) time_or_refuse(bench, trial);
      pieces.one_more();
    }
  return trials;
}

std::vector<DeckTrial> split_trials(const Campaign& campaign) {
  std::vector<DeckTrial> trials;
  for (const RankSplit split : splits_on_trial(campaign.mill, campaign.ranks))
    trials.push_back({.settings = {split, liggghts::neighbour_skin(campaign.mill)}});
  return trials;
}

std::vector<DeckTrial> skin_trials(RankSplit split, const std::vector<double>& skins) {
  std::vector<DeckTrial> trials;
  for (const double skin : skins) trials.push_back({.settings = {split, skin}});
  return trials;
}

std::string spoken_choice(const Tuning& tuning, const Campaign& campaign) {
  const double untuned = liggghts::neighbour_skin(campaign.mill);
  std::string text =
      fmt::format("neighbour skin {:.4g} mm, {} steps a second", 1e3 * tuning.chosen.skin,
                  spoken_speed(tuning, chosen_trial(tuning)));
  for (const auto& trial : tuning.skin_trials)
    if (trial.settings.skin == untuned && trial.refused.empty() && trial.settings != tuning.chosen)
      text += fmt::format(" ({:.4g} mm without the trial: {})", 1e3 * untuned,
                          spoken_speed(tuning, trial));
  if (tuning.split_trials.empty()) return text;
  std::vector<std::string> speeds;
  for (const auto& trial : tuning.split_trials)
    if (trial.refused.empty())
      speeds.push_back(
          fmt::format("{}: {}", name_of(trial.settings.rank_split), spoken_speed(tuning, trial)));
  return text + fmt::format("; ranks split by {} ({})", name_of(tuning.chosen.rank_split),
                            fmt::join(speeds, ", "));
}

}  // namespace

void tune_stage(const Campaign& campaign, const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  const auto skins = skins_on_trial(mill);
  const auto bench = bench_for(campaign, into, trial_steps(mill, skins));
  auto splits = split_trials(campaign);
  PiecesDone pieces{progress, rounds * (splits.size() + skins.size())};
  splits = timed_in_turns(bench, std::move(splits), pieces);
  const auto fastest = fastest_settings(splits);
  const RankSplit split =
      fastest ? fastest->rank_split : liggghts::rank_split(mill, campaign.ranks);
  auto tried = timed_in_turns(bench, skin_trials(split, skins), pieces);
  const DeckSettings chosen = chosen_settings(tried);
  const Tuning tuning{totals(mill).particles,
                      campaign.ranks,
                      plan_steps(mill).time_step,
                      bench.steps.timed,
                      std::move(splits),
                      std::move(tried),
                      chosen};
  for (const char* const file : {names::deck, names::contact_model, names::log})
    fs::remove(into / file);
  write_file(into / stage_files::tuning, tuning_json(tuning));
  progress.say(spoken_choice(tuning, campaign));
}

Case case_of_stretch(const Campaign& campaign, const StageId& stage) {
  const bool is_before_the_trial = stage == StageId{0, StageKind::mix};
  if (!campaign.mill.dem.tune || is_before_the_trial) return campaign.mill;
  const fs::path tuned = campaign.folder.stage({0, StageKind::tune}) / stage_files::tuning;
  return with_settings(campaign.mill, read_tuning(tuned).chosen);
}

}  // namespace millwear::orchestrator
