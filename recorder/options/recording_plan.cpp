#include "recorder/options/recording_plan.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {
namespace {

/// The options of a measurement that goes on: all of them or none.
struct GoingOnOptions {
  std::optional<double> target_error;
  std::optional<long> by_steps;
  std::optional<long> at_most;
};

void add_options(CLI::App& app, RecordingPlan& plan, GoingOnOptions& going_on) {
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
  app.add_option("--target-error", going_on.target_error,
                 "go on after --until, while the relative standard error of the smoothed rate of "
                 "loss at its peaks is above this")
      ->check(CLI::PositiveNumber);
  app.add_option("--go-on-by", going_on.by_steps, "... by so many steps at a time")
      ->check(CLI::PositiveNumber);
  app.add_option("--at-most", going_on.at_most, "... and not beyond this step")
      ->check(CLI::PositiveNumber);
}

std::optional<GoingOn> going_on_from(const GoingOnOptions& options, long last_step) {
  const int given =
      options.target_error.has_value() + options.by_steps.has_value() + options.at_most.has_value();
  if (given == 0) return std::nullopt;
  if (given < 3)
    refuse("--target-error, --go-on-by and --at-most belong together; give all or none");
  if (*options.at_most < last_step || (*options.at_most - last_step) % *options.by_steps != 0)
    refuse(
        fmt::format("--at-most {} has to be --until {} or lie a multiple of --go-on-by {} "
                    "behind it",
                    *options.at_most, last_step, *options.by_steps));
  return GoingOn{*options.target_error, *options.by_steps, *options.at_most};
}

}  // namespace

std::string recording_help() {
  RecordingPlan plan{};
  CLI::App app(
      "Runs a LIGGGHTS script as liggghts would and records every wall contact from inside:\n"
      "  mpirun -np 2 millwear-recorder --in deck.in --case case.toml --liner profile.csv "
      "--load load.h5 --after 4000 --until 24000",
      "millwear-recorder");
  GoingOnOptions going_on;
  add_options(app, plan, going_on);
  return app.help();
}

bool is_sampled(const RecordingPlan& plan, long step) {
  return step > plan.first_step && step <= plan.last_step &&
         ((step - plan.first_step) % plan.every_steps == 0 || step == plan.last_step);
}

long samples_between(const RecordingPlan& plan, long from, long to) {
  const long begin = from - plan.first_step;
  const long end = to - plan.first_step;
  return end / plan.every_steps - begin / plan.every_steps + (end % plan.every_steps != 0 ? 1 : 0);
}

RecordingPlan recording_plan(const std::vector<std::string>& arguments) {
  RecordingPlan plan{};
  CLI::App app;
  GoingOnOptions going_on;
  add_options(app, plan, going_on);
  parse_options(app, arguments, "--help");
  if (plan.last_step <= plan.first_step)
    refuse(fmt::format("--until {} has to lie after --after {}", plan.last_step, plan.first_step));
  if (plan.pairs_after &&
      (*plan.pairs_after < plan.first_step || *plan.pairs_after >= plan.last_step))
    refuse(fmt::format("--pairs-after {} has to lie from --after {} on and before --until {}",
                       *plan.pairs_after, plan.first_step, plan.last_step));
  plan.going_on = going_on_from(going_on, plan.last_step);
  return plan;
}

}  // namespace millwear::recorder
