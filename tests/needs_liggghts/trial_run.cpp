#include "tests/needs_liggghts/trial_run.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/stretch_log.h"
#include "meshgen/stl_file.h"
#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/profile_csv.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "wear/rate/wear_law.h"
#include "wear/record/collision_store.h"
#include "wear/record/load_read.h"

namespace millwear::trial {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "millwear_trial_XXXXXX").string();
  path_ = mkdtemp(name.data());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path ScratchFolder::stage(const std::string& name) const {
  fs::create_directories(path_ / name);
  return path_ / name;
}

bool liggghts_is_installed() {
  try {
    orchestrator::check_liggghts_is_installed({.contact_path = ContactPath::dumps});
    return true;
  } catch (const ExternalProgramError&) {
    return false;
  }
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

meshgen::LinerMesh write_liner_mesh(const Case& mill, const LinerProfile& liner,
                                    const fs::path& folder) {
  auto mesh =
      meshgen::build_liner_mesh(liner, mill.slice_length, {.tolerance = mesh_tolerance(mill)});
  meshgen::write_stl(mesh, folder / "liner.stl");
  return mesh;
}

namespace {

Dumps run_program(const fs::path& folder, int ranks,
                  std::optional<orchestrator::RecorderProgram> recorder) {
  Dumps dumps;
  const bool measures = text_of(folder / names::deck).find(names::contacts) != std::string::npos;
  std::vector<orchestrator::DumpPipe> pipes;
  if (measures)
    pipes = {{names::contacts, [&](std::string_view piece) { dumps.contacts += piece; }},
             {names::spins, [&](std::string_view piece) { dumps.spins += piece; }}};
  orchestrator::run_liggghts({folder, ranks, {}, std::move(recorder)}, pipes);
  return dumps;
}

void check_log(const fs::path& folder, const liggghts::StretchExpectation& expected) {
  liggghts::check_stretch_log(text_of(folder / names::log), names::log, expected);
}

}  // namespace

Dumps run_deck(const fs::path& folder, int ranks, const liggghts::StretchExpectation& expected) {
  Dumps dumps = run_program(folder, ranks, std::nullopt);
  check_log(folder, expected);
  return dumps;
}

Recording record_deck(const Case& mill, const liggghts::StretchSteps& steps,
                      const LinerProfile& liner, const fs::path& folder, int ranks,
                      liggghts::StretchExpectation expected) {
  write_text(folder / "case.toml", locked_case_text(mill));
  write_text(folder / "liner.csv", profile_csv(liner));
  RecordingPlan plan{.deck = names::deck,
                     .mill = "case.toml",
                     .liner = "liner.csv",
                     .load = "load.h5",
                     .events = "events.h5",
                     .charge = "charge.h5",
                     .first_step = steps.settle_steps,
                     .last_step = steps.total(),
                     .every_steps = steps.sample_steps,
                     .pairs_after = {},
                     .going_on = {}};
  plan.columns = liggghts::columns_to_balance(mill, ranks);
  if (steps.pair_steps > 0) plan.pairs_after = steps.total() - steps.pair_steps;
  if (steps.go_on_steps > 0)
    plan.going_on = GoingOn{mill.dem.error_target->relative_error, steps.go_on_steps,
                            steps.settle_steps + steps.most_measure_steps};
  Recording recording;
  recording.dumps = run_program(
      folder, ranks, orchestrator::RecorderProgram{MILLWEAR_RECORDER, to_arguments(plan)});
  if (steps.go_on_steps == 0) check_log(folder, expected);
  recording.record = wear::read_record(folder / "load.h5");
  recording.charge = wear::read_charge(folder / "charge.h5");
  expected.last_step = liggghts::as_measured(steps, recording.record.load.duration).total();
  check_log(folder, expected);
  wear::for_each_collision(folder / "events.h5", [&](const wear::Collision& collision) {
    recording.collisions.push_back(collision);
  });
  return recording;
}

liggghts::RunLog log_of(const fs::path& folder) {
  return liggghts::read_run_log(text_of(folder / names::log));
}

std::vector<liggghts::Snapshot> snapshots_of(const std::string& dump, std::size_t columns) {
  std::vector<liggghts::Snapshot> all;
  liggghts::SnapshotReader reader(
      "dump", columns, [&](const liggghts::Snapshot& snapshot) { all.push_back(snapshot); });
  reader.feed(dump);
  reader.finish();
  return all;
}

void join_dumps(const Case& mill, const liggghts::StretchSteps& steps, const Dumps& dumps,
                const liggghts::ContactJoin::Take& take, const liggghts::ContactJoin::Take& begin) {
  liggghts::ContactJoin join(mill, steps, take, begin);
  const auto spins = snapshots_of(dumps.spins, liggghts::spin_columns);
  for (const auto& snapshot : snapshots_of(dumps.contacts, liggghts::contact_columns))
    join.take_contacts(snapshot);
  for (const auto& snapshot : spins) join.take_spins(snapshot);
  join.finish();
}

WallLoad load_of(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                 const Dumps& dumps) {
  wear::LoadAccumulator accumulator(
      liner, load_measurement(mill, steps.measure_time(), steps.sample_interval(), 0));
  join_dumps(
      mill, steps, dumps, [&](const WallContacts& sample) { accumulator.add(sample); },
      [&](const WallContacts& sample) { accumulator.begin_with(sample); });
  const WallLoad load = accumulator.finish().load;
  wear::check_rejected_share(load, 0.0);
  return wear::coarsened(load, wear::cells_per_bin);
}

double worn_volume(const Case& mill, const WallLoad& load) {
  const auto depth =
      wear::depth_rate(wear::weights_of(mill.wear.mechanisms, mill.charge.classes), load);
  return depth.dot(load.bin_area()) * load.rows * load.duration;
}

}  // namespace millwear::trial
