#include "recorder/options/run_options.h"

#include <CLI/CLI.hpp>

#include "recorder/options/option_parsing.h"

namespace millwear::recorder {
namespace {

void add_options(CLI::App& app, std::filesystem::path& deck) {
  app.add_option("-i,--in", deck, "LIGGGHTS's input script")->required();
}

}  // namespace

std::string run_help() {
  std::filesystem::path deck;
  CLI::App app(
      "Runs a LIGGGHTS script to the same bits as liggghts would, with a search for neighbours "
      "that "
      "does not slow down where particles differ much in size:\n"
      "  mpirun -np 2 millwear-recorder run --in deck.in",
      "millwear-recorder run");
  add_options(app, deck);
  return app.help();
}

std::filesystem::path deck_option(const std::vector<std::string>& arguments) {
  std::filesystem::path deck;
  CLI::App app;
  add_options(app, deck);
  parse_options(app, arguments, "run --help");
  return deck;
}

}  // namespace millwear::recorder
