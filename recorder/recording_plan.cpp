#include "recorder/recording_plan.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "mill/failure.h"

namespace millwear::recorder {
namespace {

void add_options(CLI::App& app, RecordingPlan& plan) {
  app.add_option("-i,--in", plan.deck, "LIGGGHTS's input script")->required();
  app.add_option("--case", plan.mill, "the case file of the mill")->required();
  app.add_option("--liner", plan.liner, "profile (CSV) that the script's mesh follows")->required();
  app.add_option("--load", plan.load, "file to write: the load on the liner (HDF5)")->required();
  app.add_option("--events", plan.events, "file to write: a row a collision (HDF5)");
  app.add_option("--after", plan.first_step, "the measurement begins after this step")
      ->required()
      ->check(CLI::NonNegativeNumber);
  app.add_option("--until", plan.last_step, "... and ends with this step")
      ->required()
      ->check(CLI::PositiveNumber);
  app.add_option("--every", plan.every_steps, "steps between two samples of the wall contacts")
      ->default_val(1)
      ->check(CLI::PositiveNumber);
  app.add_option("--pairs-after", plan.pairs_after,
                 "record collisions between particles after this step; a `run` of the script has "
                 "to begin there");
}

}  // namespace

std::string recording_help() {
  RecordingPlan plan{};
  CLI::App app(
      "Runs a LIGGGHTS script as liggghts would and records every wall contact from inside:\n"
      "  mpirun -np 2 millwear-recorder --in deck.in --case case.toml --liner profile.csv "
      "--load load.h5 --after 4000 --until 24000",
      "millwear-recorder");
  add_options(app, plan);
  return app.help();
}

long samples_of(const RecordingPlan& plan) {
  return plan.last_step / plan.every_steps - plan.first_step / plan.every_steps;
}

RecordingPlan recording_plan(const std::vector<std::string>& arguments) {
  RecordingPlan plan{};
  CLI::App app;
  add_options(app, plan);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& problem) {
    throw Failure(ExitCode::usage, std::string(problem.what()) + "; see --help");
  }
  if (plan.last_step <= plan.first_step)
    throw Failure(ExitCode::usage, fmt::format("--until {} has to lie after --after {}",
                                               plan.last_step, plan.first_step));
  if (samples_of(plan) == 0)
    throw Failure(ExitCode::usage, fmt::format("--every {} gives no sample from --after {} to "
                                               "--until {}",
                                               plan.every_steps, plan.first_step, plan.last_step));
  if (plan.pairs_after &&
      (*plan.pairs_after < plan.first_step || *plan.pairs_after >= plan.last_step))
    throw Failure(
        ExitCode::usage,
        fmt::format("--pairs-after {} has to lie from --after {} on and before --until {}",
                    *plan.pairs_after, plan.first_step, plan.last_step));
  return plan;
}

}  // namespace millwear::recorder
