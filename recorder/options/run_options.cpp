#include "recorder/options/run_options.h"

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {

std::string run_help() {
  DeckRunOptions options;
  CLI::App app(
      "Runs a LIGGGHTS script to the same bits as liggghts would, with a search for neighbours "
      "that does not slow down where particles differ much in size:\n"
      "  mpirun -np 2 millwear-recorder run --in deck.in",
      "millwear-recorder run");
  for_each_option(options, into(app));
  return app.help();
}

DeckRunOptions run_options(const std::vector<std::string>& arguments) {
  DeckRunOptions options;
  CLI::App app;
  for_each_option(options, into(app));
  parse_options(app, arguments, "run --help");
  return options;
}

}  // namespace millwear::recorder
