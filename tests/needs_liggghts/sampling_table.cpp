#include <fmt/format.h>

#include <cmath>

#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "tests/needs_liggghts/mill_trial.h"

// Prints what sampling the wall contacts costs in truth: the pilot mill, one trajectory, recorded
// and dumped every N steps, against the recorder at every step. A table for docs/physics.md.

namespace {

using namespace millwear;
using namespace millwear::trial;

double sum(const WallLoad& load, Measure measure) { return load.total(measure).sum(); }

void print_row(const char* path, long every, const WallLoad& load, const WallLoad& truth) {
  fmt::print("| {} | {} |", path, every);
  for (const Measure measure : {Measure::events, Measure::sliding_work, Measure::normal_dissipation,
                                Measure::shear_dissipation, Measure::incident_energy})
    fmt::print(" {:+.1f} |", 100.0 * (sum(load, measure) / sum(truth, measure) - 1.0));
  const auto& mine = load.total(Measure::sliding_work);
  const auto& true_work = truth.total(Measure::sliding_work);
  fmt::print(" {:.1f} |\n", 50.0 * (mine / mine.sum() - true_work / true_work.sum()).lpNorm<1>());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double revolutions = argc > 1 ? std::atof(argv[1]) : 0.3;
  Case mill = read_case(MILLWEAR_CASES "/pilot_mill/case.toml");
  mill.dem.contact_path = ContactPath::dumps;
  const auto plan = plan_steps(mill);
  const long revolution = plan.steps_per_revolution(mill.liner.sector.rows);
  const long settling = 600;
  const long measured =
      static_cast<long>(revolutions * static_cast<double>(revolution)) / settling * settling;
  const ScratchFolder scratch;
  mix(mill, {plan.time_step, revolution, 0, 20}, scratch.stage("mix"), 1);
  const auto load_recorded = [&](const liggghts::StretchSteps& steps) {
    const auto recording = record(mill, steps, mill.liner, scratch.stage("dem"), "mix", 1);
    return std::pair(wear::coarsened(recording.record.load, wear::cells_per_bin),
                     mill.dem.contact_path == ContactPath::dumps
                         ? load_of(mill, steps, mill.liner, recording.dumps)
                         : WallLoad{});
  };
  WallLoad truth;
  for (const long every : {1, 2, 5, 10, 20, 40, 100}) {
    const auto [recorded, dumped] = load_recorded({plan.time_step, settling, measured, every});
    if (every == 1) {
      truth = recorded;
      fmt::print("{} collisions, {} contacts in {} steps of {:.3g} s; differences in %\n\n",
                 sum(truth, Measure::events), sum(truth, Measure::samples), measured,
                 plan.time_step);
      fmt::print("| path | every | events | sliding | normal | shear | incident | misplaced |\n");
    }
    print_row("recorder", every, recorded, truth);
    print_row("dumps", every, dumped, truth);
  }
  // Another trajectory: it differs by chance as well, some 1 / sqrt(collisions).
  mill.dem.contact_path = ContactPath::recorder;
  const auto halved = load_recorded({0.5 * plan.time_step, 2 * settling, 2 * measured, 1}).first;
  print_row("recorder, half the time step", 1, halved, truth);
}
