#include "orchestrator/dem_run/stretch_stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "liggghts_inputs/decks/charge_data.h"
#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/contact_join.h"
#include "liggghts_inputs/outputs/stretch_log.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/dem_run/charge_source.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/dem_run/stretch_measures.h"
#include "orchestrator/dem_run/stretch_progress.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

constexpr std::uintmax_t restart_bytes_per_particle = 100;
constexpr std::uintmax_t spare_disk_bytes = 64 << 20;
constexpr std::uintmax_t dump_bytes_per_particle = 200;

const char* const mesh_from_stage = "../mesh/liner.stl";
const char* const profile_from_stage = "../mesh/profile.csv";
const char* const locked_case_from_stage = "../../case.lock.toml";

std::string previous_restart(const Campaign& campaign, int cycle) {
  const bool is_mixed_anew = first_cycle_of_rotation(campaign, cycle) == cycle;
  return is_mixed_anew ? fmt::format("../mix/{}", names::restart)
                       : fmt::format("../../cycle_{:03}/dem/{}", cycle - 1, names::restart);
}

liggghts::LinerMeshFile mesh_of(const Campaign& campaign, int cycle) {
  return {mesh_from_stage, triangles_of_mesh(campaign.folder.stage({cycle, StageKind::mesh}))};
}

/// The load of the longest measurement that may come of it, before it is packed.
std::uintmax_t bytes_of_load(const Case& mill, const liggghts::StretchSteps& steps) {
  if (steps.measure_steps == 0) return 0;
  const long longest = std::max(steps.measure_steps, steps.most_measure_steps);
  const auto blocks =
      static_cast<std::uintmax_t>(mill.wear.time_blocks * longest / steps.measure_steps);
  const auto cells = static_cast<std::uintmax_t>(mill.wear.bins * wear::cells_per_bin);
  return blocks * cells * mill.charge.classes.size() * measure_count * sizeof(double);
}

void check_free_disk(const Case& mill, const liggghts::StretchSteps& steps, const fs::path& into) {
  const auto particles = static_cast<std::uintmax_t>(totals(mill).particles);
  std::uintmax_t needed = spare_disk_bytes + 2 * 1000 * particles + bytes_of_load(mill, steps);
  if (mill.dem.keep_dumps)
    needed += static_cast<std::uintmax_t>(steps.samples()) * particles * dump_bytes_per_particle;
  const auto free = fs::space(into).available;
  if (free < needed)
    throw DiskError(
        fmt::format("{}: {} MB are free and this stretch needs {} MB; free some, or "
                    "give --out a folder on another disk",
                    into.string(), free >> 20, (needed >> 20) + 1));
}

void check_stretch(const Campaign& campaign, int cycle, const liggghts::StretchSteps& steps,
                   const fs::path& into) {
  const fs::path log = into / names::log;
  const std::size_t particles = totals(campaign.mill).particles;
  liggghts::check_stretch_log(read_file(log), log.string(),
                              {particles, mesh_of(campaign, cycle).triangles, steps.total()});
  const fs::path restart = into / names::restart;
  if (!fs::exists(restart) || fs::file_size(restart) < restart_bytes_per_particle * particles)
    throw ResultRejected(fmt::format("{}: too short for {} particles; is the disk full?",
                                     restart.string(), particles));
}

/// Follows LIGGGHTS's printed steps, of which settling starts at 0 and nothing else.
std::function<void(std::string_view)> step_follower(const StageId& stage,
                                                    const liggghts::StretchSteps& steps,
                                                    Progress& progress) {
  return [&progress, name = name_of(stage),
          stretch = StretchProgress(steps)](std::string_view line) mutable {
    const bool went_on = stretch.goes_on();
    if (!stretch.take(line)) return;
    if (stretch.goes_on() && !went_on) progress.rename(name + ", going on");
    progress.advance(stretch.done());
  };
}

/// The steps as they went, where the recorder left a load; else as they were to go.
liggghts::StretchSteps steps_of_load(const liggghts::StretchSteps& planned, const fs::path& into) {
  const fs::path load = into / stage_files::load;
  if (!fs::exists(load)) return planned;
  const double duration = wear::read_load(load).duration;
  try {
    return liggghts::as_measured(planned, duration);
  } catch (const ResultRejected& problem) {
    throw ResultRejected(fmt::format("{}: {}", load.string(), problem.what()));
  }
}

/// Runs the deck with the recorder, which leaves the load.
void record(const Campaign& campaign, int cycle, const liggghts::StretchSteps& planned,
            const fs::path& into, Progress& progress) {
  run_liggghts({into, campaign.ranks, step_follower({cycle, StageKind::dem}, planned, progress),
                RecorderProgram{recorder_program(), recorder_arguments(campaign.mill)},
                campaign.mill.dem.launcher},
               {});
  check_stretch(campaign, cycle, steps_of_load(planned, into), into);
  std::vector<const char*> files = {stage_files::load};
  if (campaign.mill.dem.keep_events) files.push_back(stage_files::events);
  for (const char* const file : files)
    if (!fs::exists(into / file))
      throw ResultRejected(fmt::format("{}: the recorder left no {}; see this log for why",
                                       (into / names::log).string(), file));
}

/// Runs the deck with the plain liggghts and sums what it dumps.
void read_dumps(const Campaign& campaign, int cycle, const liggghts::StretchSteps& steps,
                const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  wear::LoadAccumulator load(dem_liner_of_cycle(campaign, cycle),
                             load_measurement(mill, steps.measure_time(), steps.sample_interval(),
                                              mesh_of(campaign, cycle).triangles));
  liggghts::ContactJoin join(
      mill, steps, [&](const WallContacts& sample) { load.add(sample); },
      [&](const WallContacts& sample) { load.begin_with(sample); });
  liggghts::SnapshotReader contacts(
      (into / names::contacts).string(), liggghts::contact_columns,
      [&](const liggghts::Snapshot& snapshot) { join.take_contacts(snapshot); });
  liggghts::SnapshotReader spins(
      (into / names::spins).string(), liggghts::spin_columns,
      [&](const liggghts::Snapshot& snapshot) { join.take_spins(snapshot); });
  const std::vector<DumpPipe> dumps = {
      {names::contacts, [&](std::string_view piece) { contacts.feed(piece); }},
      {names::spins, [&](std::string_view piece) { spins.feed(piece); }}};

  run_liggghts({into,
                campaign.ranks,
                step_follower({cycle, StageKind::dem}, steps, progress),
                {},
                mill.dem.launcher},
               mill.dem.keep_dumps ? std::vector<DumpPipe>{} : dumps);
  check_stretch(campaign, cycle, steps, into);
  if (mill.dem.keep_dumps)
    for (const auto& dump : dumps) read_dump_file(into / dump.name, dump.take);
  contacts.finish();
  spins.finish();
  join.finish();
  wear::write_record(into / stage_files::load, load.finish());
}

/// Runs the mixing deck with the recorder, which ends it once it is steady.
void mix_until_steady(const Campaign& campaign, int cycle, const fs::path& into,
                      Progress& progress) {
  const StageId stage{cycle, StageKind::mix};
  auto steps = liggghts::mixing_steps(campaign.mill, plan_steps(campaign.mill));
  const auto follow_drift = drift_follower(name_of(stage), progress);
  auto follow_steps = step_follower(stage, steps, progress);
  const auto take_line = [&](std::string_view line) {
    follow_drift(line);
    follow_steps(line);
  };
  run_liggghts({into, campaign.ranks, take_line,
                RecorderProgram{recorder_program(), mixing_arguments(campaign.mill)},
                campaign.mill.dem.launcher},
               {});
  // Without a record it did not come to its end, and the log tells why.
  if (!fs::exists(into / stage_files::mixing)) return check_stretch(campaign, cycle, steps, into);
  const auto record = read_mixing(campaign.mill, into);
  steps.settle_steps = record.steps();
  check_stretch(campaign, cycle, steps, into);
  progress.say(fmt::format("cycle {}: {}", cycle, spoken_mixing(record)));
}

}  // namespace

std::string write_mixing_deck(const Campaign& campaign, int cycle, const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::mix});
  const auto steps = liggghts::mixing_steps(mill, plan_steps(mill));
  const FirstCharge charge = first_charge(campaign, cycle, into);
  write_file(into / names::charge, liggghts::charge_data_file(mill, charge.particles));
  write_file(into / names::deck, liggghts::mixing_deck(mill, steps, campaign.ranks));
  write_file(into / names::contact_model,
             liggghts::contact_model_deck(mill, steps, mesh_of(campaign, cycle),
                                          liggghts::StretchKind::mix, cycle));
  return charge.words;
}

void write_measuring_deck(const Campaign& campaign, int cycle, const fs::path& into) {
  const Case mill = case_of_stretch(campaign, {cycle, StageKind::dem});
  const auto steps = liggghts::measuring_steps(mill, plan_steps(mill));
  write_file(into / names::deck,
             liggghts::measuring_deck(mill, steps, dem_liner_of_cycle(campaign, cycle),
                                      previous_restart(campaign, cycle), campaign.ranks));
  write_file(into / names::contact_model,
             liggghts::contact_model_deck(mill, steps, mesh_of(campaign, cycle),
                                          liggghts::StretchKind::measure, cycle));
}

std::vector<std::string> recorder_arguments(const Case& mill) {
  const auto steps = liggghts::measuring_steps(mill, plan_steps(mill));
  RecordingPlan plan{.deck = names::deck,
                     .mill = locked_case_from_stage,
                     .liner = profile_from_stage,
                     .load = stage_files::load,
                     .events = {},
                     .first_step = steps.settle_steps,
                     .last_step = steps.total(),
                     .every_steps = steps.sample_steps,
                     .pairs_after = {},
                     .going_on = {}};
  if (mill.dem.keep_events) plan.events = stage_files::events;
  if (steps.pair_steps > 0) plan.pairs_after = steps.total() - steps.pair_steps;
  if (mill.dem.error_target)
    plan.going_on = GoingOn{mill.dem.error_target->relative_error, steps.go_on_steps,
                            steps.settle_steps + steps.most_measure_steps};
  return to_arguments(plan);
}

void mix_stage(const Campaign& campaign, int cycle, const fs::path& into, Progress& progress) {
  const auto steps = liggghts::mixing_steps(campaign.mill, plan_steps(campaign.mill));
  check_free_disk(campaign.mill, steps, into);
  if (const auto words = write_mixing_deck(campaign, cycle, into); !words.empty())
    progress.say(fmt::format("cycle {}: {}", cycle, words));
  if (campaign.mill.dem.mix_until_steady) return mix_until_steady(campaign, cycle, into, progress);
  run_liggghts({into, campaign.ranks, step_follower({cycle, StageKind::mix}, steps, progress),
                unrecorded_program(campaign.mill.dem.contact_path), campaign.mill.dem.launcher},
               {});
  check_stretch(campaign, cycle, steps, into);
}

void simulate_load(const Campaign& campaign, int cycle, const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  const auto steps = liggghts::measuring_steps(mill, plan_steps(mill));
  check_free_disk(mill, steps, into);
  write_measuring_deck(campaign, cycle, into);
  if (mill.dem.contact_path == ContactPath::recorder)
    record(campaign, cycle, steps, into, progress);
  else
    read_dumps(campaign, cycle, steps, into, progress);
}

void measure_load(const Campaign& campaign, int cycle, const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  const auto record = wear::read_record(into / stage_files::load);
  wear::check_rejected_share(record.load, largest_rejected_share);
  const auto steps = steps_of_load(liggghts::measuring_steps(mill, plan_steps(mill)), into);
  const Measured measured = stretch_measures(mill, dem_liner_of_cycle(campaign, cycle), steps,
                                             record, into / names::torque);
  write_measured(into / stage_files::measured, measured);
  progress.say(fmt::format("cycle {}: {}", cycle, spoken_end(measured)));
}

}  // namespace millwear::orchestrator
