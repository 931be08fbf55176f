#include "recorder/options/mixing_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {
namespace {

void add_options(CLI::App& app, MixingOptions& options) {
  auto& plan = options.plan;
  app.add_option("-i,--in", options.deck, "LIGGGHTS's input script, with one `run`")->required();
  app.add_option("--record", options.record, "file to write: how it went (CSV)")->required();
  app.add_option("--piece", plan.piece,
                 "steps that torque and kinetic energy are averaged over, by the script's "
                 "`fix drift all ave/time`; whole pitches")
      ->required()
      ->check(CLI::PositiveNumber);
  app.add_option("--after", plan.left_out, "what comes up to this step is left out")
      ->required()
      ->check(CLI::NonNegativeNumber);
  app.add_option("--at-most", plan.most, "the last step it may reach; the script's `run`")
      ->required()
      ->check(CLI::PositiveNumber);
  app.add_option("--revolution", plan.revolution, "steps of one revolution")
      ->required()
      ->check(CLI::PositiveNumber);
}

}  // namespace

std::string mixing_help() {
  MixingOptions options{};
  CLI::App app(
      "Runs a LIGGGHTS script as liggghts would, but ends its `run` as soon as the torque and the "
      "kinetic energy of the charge drift no longer:\n"
      "  mpirun -np 2 millwear-recorder mix --in deck.in --record mixing.csv --piece 400 "
      "--after 2400 --at-most 19200 --revolution 9600",
      "millwear-recorder mix");
  add_options(app, options);
  return app.help();
}

MixingOptions mixing_options(const std::vector<std::string>& arguments) {
  MixingOptions options{};
  CLI::App app;
  add_options(app, options);
  parse_options(app, arguments, "mix --help");
  const auto& plan = options.plan;
  for (const auto& [name, steps] :
       {std::pair{"--after", plan.left_out}, std::pair{"--at-most", plan.most}})
    if (steps % plan.piece != 0)
      refuse(fmt::format("{} {} has to be a multiple of --piece {}", name, steps, plan.piece));
  return options;
}

}  // namespace millwear::recorder
