#include "recorder/run/deck_run.h"

#include <fmt/format.h>
#include <liggghts/input.h>
#include <liggghts/lammps.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

#include "mill/base/failure.h"
#include "recorder/run/deck_lines.h"

namespace millwear::recorder {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": there is no such deck");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Commands with which a deck does not run from its top to its bottom on one LIGGGHTS.
bool leaves_the_way(std::string_view command) {
  constexpr std::array<std::string_view, 7> commands = {"clear", "if",   "jump",     "label",
                                                        "next",  "quit", "partition"};
  return std::ranges::find(commands, command) != commands.end();
}

}  // namespace

void run_deck(LAMMPS_NS::LAMMPS& liggghts, const std::filesystem::path& deck,
              const std::function<void(const std::string& line)>& take_run) {
  for (const auto& line : deck_lines(text_of(deck))) {
    const auto command = command_of(line);
    if (command == "include")
      run_deck(liggghts, argument_of(line), take_run);
    else if (command == "run")
      take_run(line);
    else if (leaves_the_way(command))
      throw InputError(fmt::format(
          "{}: `{}`: the recorder runs a deck from top to bottom; write the deck without `{}`, "
          "or set wall_contacts = \"dumps\"",
          deck.string(), line, command));
    else
      liggghts.input->one(line.c_str());
  }
}

}  // namespace millwear::recorder
