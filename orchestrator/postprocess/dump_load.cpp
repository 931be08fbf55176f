#include "orchestrator/postprocess/dump_load.h"

#include <fmt/format.h>

#include "liggghts_inputs/outputs/contact_join.h"
#include "mill/base/failure.h"
#include "orchestrator/dem_run/stretch_measures.h"
#include "orchestrator/postprocess/deck_axes.h"
#include "orchestrator/postprocess/dump_source.h"
#include "wear/record/load_accumulator.h"

namespace millwear::orchestrator {
namespace {

liggghts::DumpFrame frame_of(const HandRun& run, const DumpOutline& outline) {
  return {.time_step = run.time_step,
          .first_step = outline.steps.front(),
          .last_step = outline.steps.back(),
          .samples = static_cast<long>(outline.steps.size()) - 1,
          .angle = run.angle,
          .angle_step = run.angle_step,
          .to_mill = axes_to_mill(run.turns_about, run.gravity)};
}

LoadMeasurement measurement_of(const Case& mill, std::size_t triangles, const HandRun& run,
                               const DumpOutline& outline) {
  const long measured = outline.steps.back() - outline.steps.front();
  auto measurement =
      load_measurement(mill, run.time_step * static_cast<double>(measured),
                       run.time_step * static_cast<double>(outline.sample_steps), triangles);
  measurement.particles = outline.largest_particle;
  return measurement;
}

void check_blocks(const Case& mill, const HandRun& run, const DumpOutline& outline) {
  const auto samples = static_cast<int>(outline.steps.size()) - 1;
  if (samples < mill.wear.time_blocks)
    throw ResultRejected(
        fmt::format("{}: {} samples, and the case wants {} time blocks; dump more often or for "
                    "longer, or set a smaller `time_blocks` in [wear]",
                    run.contacts.string(), samples, mill.wear.time_blocks));
}

void check_liner(const WallLoad& load, const HandRun& run) {
  try {
    wear::check_rejected_share(load, largest_rejected_share);
  } catch (const ResultRejected& problem) {
    throw ResultRejected(fmt::format(
        "{}: {}. The deck's liner is not that of the case, or it stands at another angle: see "
        "--profile, --angle-deg, --angle-step, --timestep, --turns-about and --gravity",
        run.contacts.string(), problem.what()));
  }
}

wear::LinerRecord record_of(const Case& mill, std::size_t triangles, const HandRun& run,
                            const DumpOutline& outline) {
  wear::LoadAccumulator load(mill.liner, measurement_of(mill, triangles, run, outline));
  liggghts::ContactJoin join(
      mill, outline.largest_particle, frame_of(run, outline),
      [&](const WallContacts& sample) { load.add(sample); },
      [&](const WallContacts& sample) { load.begin_with(sample); });
  const auto is_measured = [&](const liggghts::Snapshot& snapshot) {
    return snapshot.step >= outline.steps.front() && snapshot.step <= outline.steps.back();
  };
  DumpSource contacts(run.contacts, liggghts::choose_contact_columns(run.contact_keywords),
                      [&](const liggghts::Snapshot& snapshot) {
                        if (is_measured(snapshot)) join.take_contacts(snapshot);
                      });
  DumpSource particles(run.particles, liggghts::choose_spin_columns(),
                       [&](const liggghts::Snapshot& snapshot) {
                         if (is_measured(snapshot)) join.take_spins(snapshot);
                       });
  try {
    read_side_by_side(contacts, particles);
    join.finish();
  } catch (const ResultRejected& problem) {
    throw ResultRejected(fmt::format("{} and {}: {}", run.contacts.string(), run.particles.string(),
                                     problem.what()));
  }
  return load.finish();
}

}  // namespace

DumpLoad load_of_dumps(const Case& mill, std::size_t triangles, const HandRun& run) {
  if (!(run.time_step > 0.0))
    throw InputError(fmt::format("a time step of {} s; give the deck's `timestep`", run.time_step));
  try {
    DumpOutline outline = outline_of(run, triangles);
    check_blocks(mill, run, outline);
    auto record = record_of(mill, triangles, run, outline);
    check_liner(record.load, run);
    return {std::move(record), std::move(outline)};
  } catch (const ResultRejected& problem) {
    // What the dumps of a campaign would be rejected for is the user's input here.
    throw InputError(problem.what());
  }
}

}  // namespace millwear::orchestrator
