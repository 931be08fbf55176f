#include "orchestrator/process/logged_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// An open file of a child, which closes with this.
class ChildFile {
 public:
  ChildFile(const fs::path& file, int flags) : fd_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (fd_ < 0)
      throw DiskError(fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno)));
  }
  ~ChildFile() { ::close(fd_); }
  ChildFile(const ChildFile&) = delete;
  ChildFile& operator=(const ChildFile&) = delete;
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
};

}  // namespace

std::unique_ptr<ChildProcess> start_logged(const std::vector<std::string>& command,
                                           const fs::path& log) {
  const ChildFile output(log, O_WRONLY | O_APPEND | O_CREAT);
  const ChildFile input("/dev/null", O_RDONLY);
  return std::make_unique<ChildProcess>(command, fs::current_path(),
                                        ChildFiles{input.fd(), output.fd(), output.fd()});
}

}  // namespace millwear::orchestrator
