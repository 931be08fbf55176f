#pragma once
#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace millwear::orchestrator {

/// A row of the table of verbs.
struct Verb {
  const char* name;
  const char* help;      ///< one line
  const char* examples;  ///< command lines, each after two blanks
  /// Adds the verb's options to its command line. What it returns carries the verb out with the
  /// options as they were parsed: it prints the result to standard output, and throws Failures and
  /// Interrupted.
  std::function<void()> (*prepare)(CLI::App& command_line);
};

/// All verbs, in the order of --help. A new verb is a file of its own and a row here.
[[nodiscard]] std::span<const Verb> verbs();

}  // namespace millwear::orchestrator
