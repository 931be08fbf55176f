#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "mill/base/failure.h"
#include "orchestrator/app/command_line.h"
#include "orchestrator/dem_run/child_process.h"

namespace {

using namespace millwear;
using namespace millwear::orchestrator;

/// Puts /dev/null where the caller closed a standard stream: else the next file that is opened, a
/// ledger or a lock, would take its number and be written into by every message.
void hold_standard_streams() {
  int fd = ::open("/dev/null", O_RDWR);
  while (fd >= 0 && fd <= STDERR_FILENO) fd = ::open("/dev/null", O_RDWR);
  if (fd > STDERR_FILENO) ::close(fd);
}

/// Throws DiskError where a result did not reach standard output.
void flush_results() {
  if (std::fflush(stdout) != 0)
    throw DiskError(
        fmt::format("standard output: the result cannot be written: {}", std::strerror(errno)));
}

}  // namespace

int main(int argc, char** argv) {
  hold_standard_streams();
  try {
    const ParsedCommandLine parsed = parse_command_line(argc, argv);
    if (!parsed.action) return parsed.exit_code;
    note_interrupts();
    parsed.action();
    flush_results();
    return static_cast<int>(ExitCode::ok);
  } catch (const Failure& failure) {
    fmt::print(stderr, "millwear: {}\n", failure.what());
    return static_cast<int>(failure.exit_code);
  } catch (const Interrupted& interrupted) {
    fmt::print(stderr, "millwear: stopped; the same command goes on from here\n");
    return 128 + interrupted.signal;
  } catch (const std::filesystem::filesystem_error& problem) {
    fmt::print(stderr, "millwear: {}: {}\n", problem.path1().string(), problem.code().message());
    return static_cast<int>(ExitCode::disk);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "millwear: internal error: {}; please report it\n", problem.what());
    return static_cast<int>(ExitCode::internal);
  }
}
