#include <fmt/format.h>

#include <exception>

#include "mill/failure.h"
#include "orchestrator/child_process.h"
#include "orchestrator/verbs.h"

namespace {

using namespace millwear;
using namespace millwear::orchestrator;

void carry_out(const Command& command) {
  switch (command.verb) {
    case Verb::check:
      return check_verb(command);
    case Verb::mesh:
      return mesh_verb(command);
    case Verb::deck:
      return deck_verb(command);
    case Verb::run:
      return run_verb(command);
    case Verb::status:
      return status_verb(command);
    case Verb::report:
      return report_verb(command);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const ParsedCommandLine parsed = parse_command_line(argc, argv);
    if (!parsed.command) return parsed.exit_code;
    note_interrupts();
    carry_out(*parsed.command);
    return static_cast<int>(ExitCode::ok);
  } catch (const Failure& failure) {
    fmt::print(stderr, "millwear: {}\n", failure.what());
    return static_cast<int>(failure.exit_code);
  } catch (const Interrupted& interrupted) {
    fmt::print(stderr, "millwear: stopped; the same command goes on from here\n");
    return 128 + interrupted.signal;
  } catch (const std::filesystem::filesystem_error& problem) {
    fmt::print(stderr, "millwear: {}\n", problem.what());
    return static_cast<int>(ExitCode::disk);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "millwear: internal error: {}; please report it\n", problem.what());
    return static_cast<int>(ExitCode::internal);
  }
}
