#include "recorder/options/option_parsing.h"

#include <CLI/CLI.hpp>

#include "mill/base/failure.h"

namespace millwear::recorder {

void refuse(const std::string& why) { throw Failure(ExitCode::usage, why); }

void parse_options(CLI::App& app, const std::vector<std::string>& arguments,
                   const std::string& help) {
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& problem) {
    refuse(std::string(problem.what()) + "; see " + help);
  }
}

}  // namespace millwear::recorder
