#include "orchestrator/pictures/gnuplot.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "mill/base/failure.h"
#include "orchestrator/process/child_process.h"

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

}  // namespace

std::string gnuplot_output(std::string_view commands) {
  MemoryFile input, output, messages;
  input.fill(commands);
  ChildProcess gnuplot({program_on_path("gnuplot", "gnuplot-nox").string()},
                       std::filesystem::current_path(),
                       ChildFiles{input.descriptor(), output.descriptor(), messages.descriptor()});
  if (const int code = gnuplot.wait(); code != 0)
    throw ExternalProgramError(
        fmt::format("gnuplot failed (exit code {}): {}", code, messages.content()));
  return output.content();
}

}  // namespace millwear::orchestrator
