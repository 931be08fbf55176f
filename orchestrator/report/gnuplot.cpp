#include "orchestrator/report/gnuplot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

/// A file without a name that is gone with this object.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("millwear plot", MFD_CLOEXEC)) {
    if (descriptor_ < 0)
      throw DiskError(fmt::format("no memory file for a plot: {}", std::strerror(errno)));
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  void fill(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0) throw DiskError(fmt::format("a plot: {}", std::strerror(errno)));
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }

  [[nodiscard]] std::string content() const {
    std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
    if (::pread(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
      throw DiskError(fmt::format("a plot cannot be read back: {}", std::strerror(errno)));
    return text;
  }

 private:
  int descriptor_;
};

pid_t started(const MemoryFile& input, const MemoryFile& output, const MemoryFile& messages) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, input.descriptor(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
  std::array<char, 8> name = {"gnuplot"};
  std::array<char*, 2> arguments = {name.data(), nullptr};
  pid_t process = 0;
  const int problem =
      ::posix_spawnp(&process, name.data(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (problem != 0)
    throw ExternalProgramError(
        fmt::format("gnuplot cannot be started ({}); install gnuplot-nox "
                    "(apt-get install gnuplot-nox)",
                    std::strerror(problem)));
  return process;
}

}  // namespace

std::string gnuplot_output(std::string_view commands) {
  MemoryFile input, output, messages;
  input.fill(commands);
  const pid_t process = started(input, output, messages);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      throw ExternalProgramError(fmt::format("gnuplot was lost: {}", std::strerror(errno)));
  if (status != 0)
    throw ExternalProgramError(
        fmt::format("gnuplot failed (wait status {}): {}", status, messages.content()));
  return output.content();
}

}  // namespace millwear::orchestrator
