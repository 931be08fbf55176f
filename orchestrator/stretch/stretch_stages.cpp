#include "orchestrator/stretch/stretch_stages.h"

#include <fmt/format.h>

#include "liggghts_inputs/decks/chunks.h"
#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/contact_join.h"
#include "mill/base/failure.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/dem_run/stretch_measures.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/stretch/chunked_stretch.h"
#include "orchestrator/stretch/step_follower.h"
#include "orchestrator/stretch/stretch_checks.h"
#include "orchestrator/stretch/stretch_decks.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

void check(const Campaign& campaign, int cycle, const liggghts::StretchSteps& steps,
           const fs::path& into) {
  check_stretch(campaign.mill, steps, mesh_of_cycle(campaign, cycle).triangles, into);
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
  run_liggghts(
      {into, campaign.ranks,
       step_follower(name_of(StageId{cycle, StageKind::dem}), planned, progress),
       RecorderProgram{recorder_program(), recorder_arguments(campaign.mill, campaign.ranks)},
       campaign.mill.dem.launcher},
      {});
  check(campaign, cycle, steps_of_load(planned, into), into);
  check_recorded(campaign.mill, into);
}

/// Runs the deck with the plain liggghts and sums what it dumps.
void read_dumps(const Campaign& campaign, int cycle, const liggghts::StretchSteps& steps,
                const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  wear::LoadAccumulator load(dem_liner_of_cycle(campaign, cycle),
                             load_measurement(mill, steps.measure_time(), steps.sample_interval(),
                                              mesh_of_cycle(campaign, cycle).triangles));
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
                step_follower(name_of(StageId{cycle, StageKind::dem}), steps, progress),
                {},
                mill.dem.launcher},
               mill.dem.keep_dumps ? std::vector<DumpPipe>{} : dumps);
  check(campaign, cycle, steps, into);
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
  auto follow_steps = step_follower(name_of(stage), steps, progress);
  const auto take_line = [&](std::string_view line) {
    follow_drift(line);
    follow_steps(line);
  };
  run_liggghts(
      {into, campaign.ranks, take_line,
       RecorderProgram{recorder_program(), mixing_arguments(campaign.mill, campaign.ranks)},
       campaign.mill.dem.launcher},
      {});
  // Without a record it did not come to its end, and the log tells why.
  if (!fs::exists(into / stage_files::mixing)) return check(campaign, cycle, steps, into);
  const auto record = read_mixing(campaign.mill, into);
  steps.settle_steps = record.steps();
  check(campaign, cycle, steps, into);
  progress.say(fmt::format("cycle {}: {}", cycle, spoken_mixing(record)));
}

}  // namespace

void mix_stage(const Campaign& campaign, int cycle, const fs::path& into, Progress& progress) {
  const auto steps = liggghts::mixing_steps(campaign.mill, plan_steps(campaign.mill));
  check_free_disk(campaign.mill, steps, into);
  const auto chunks = liggghts::chunks_of(campaign.mill, steps, plan_steps(campaign.mill));
  if (chunks.size() > 1) return mix_in_chunks(campaign, cycle, chunks, into, progress);
  if (const auto words = write_mixing_deck(campaign, cycle, into); !words.empty())
    progress.say(fmt::format("cycle {}: {}", cycle, words));
  if (campaign.mill.dem.mix_until_steady) return mix_until_steady(campaign, cycle, into, progress);
  run_liggghts({into, campaign.ranks,
                step_follower(name_of(StageId{cycle, StageKind::mix}), steps, progress),
                unrecorded_program(campaign.mill, campaign.ranks), campaign.mill.dem.launcher},
               {});
  check(campaign, cycle, steps, into);
}

void simulate_load(const Campaign& campaign, int cycle, const fs::path& into, Progress& progress) {
  const auto& mill = campaign.mill;
  const auto steps = liggghts::measuring_steps(mill, plan_steps(mill));
  check_free_disk(mill, steps, into);
  const auto chunks = liggghts::chunks_of(mill, steps, plan_steps(mill));
  if (chunks.size() > 1) return record_in_chunks(campaign, cycle, steps, chunks, into, progress);
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
