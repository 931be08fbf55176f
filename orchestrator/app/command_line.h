#pragma once
#include <functional>

namespace millwear::orchestrator {

/// What the command line asks for: an action, or the exit code with which the program ends at once
/// (help, version, wrong usage).
struct ParsedCommandLine {
  std::function<void()> action;  ///< empty where there is none
  int exit_code;
};

/// Parses the command line by the table of verbs. Help and version go to standard output; wrong
/// usage to standard error, with the verb or option that is nearest to what was written.
[[nodiscard]] ParsedCommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace millwear::orchestrator
