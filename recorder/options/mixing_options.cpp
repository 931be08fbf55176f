#include "recorder/options/mixing_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {

std::string mixing_help() {
  MixingOptions options{};
  CLI::App app(
      "Runs a LIGGGHTS script as liggghts would, but ends its `run` as soon as the torque and the "
      "kinetic energy of the charge drift no longer:\n"
      "  mpirun -np 2 millwear-recorder mix --in deck.in --record mixing.csv --piece 400 "
      "--after 2400 --at-most 19200 --revolution 9600",
      "millwear-recorder mix");
  for_each_option(options, into(app));
  return app.help();
}

MixingOptions mixing_options(const std::vector<std::string>& arguments) {
  MixingOptions options{};
  CLI::App app;
  for_each_option(options, into(app));
  parse_options(app, arguments, "mix --help");
  const auto& plan = options.plan;
  for (const auto& [name, steps] :
       {std::pair{"--after", plan.left_out}, std::pair{"--at-most", plan.most}})
    if (steps % plan.piece != 0)
      refuse(fmt::format("{} {} has to be a multiple of --piece {}", name, steps, plan.piece));
  return options;
}

}  // namespace millwear::recorder
