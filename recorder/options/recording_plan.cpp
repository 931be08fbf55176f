#include "recorder/options/recording_plan.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {
namespace {

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
  for_each_option(plan, going_on, into(app));
  return app.help();
}

RecordingPlan recording_plan(const std::vector<std::string>& arguments) {
  RecordingPlan plan{};
  CLI::App app;
  GoingOnOptions going_on;
  for_each_option(plan, going_on, into(app));
  parse_options(app, arguments, "--help");
  if (plan.last_step <= plan.first_step)
    refuse(fmt::format("--until {} has to lie after --after {}", plan.last_step, plan.first_step));
  if (plan.pairs_after &&
      (*plan.pairs_after < plan.first_step || *plan.pairs_after >= plan.last_step))
    refuse(fmt::format("--pairs-after {} has to lie from --after {} on and before --until {}",
                       *plan.pairs_after, plan.first_step, plan.last_step));
  plan.going_on = going_on_from(going_on, plan.last_step);
  if (plan.measured_before.has_value() != plan.block_steps.has_value())
    refuse("--measured-before and --block-steps belong together; give both or none");
  if (plan.measured_before && plan.going_on)
    refuse("a part of a measurement (--measured-before) does not go on (--target-error)");
  return plan;
}

}  // namespace millwear::recorder
