#include "orchestrator/campaign/run_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "mill/base/failure.h"

namespace millwear::orchestrator {

RunLock::RunLock(const std::filesystem::path& file)
    : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (fd_ < 0)
    throw DiskError(fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno)));
  if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    std::array<char, 64> holder{};
    const ssize_t length = ::read(fd_, holder.data(), holder.size() - 1);
    ::close(fd_);
    throw Failure(ExitCode::locked,
                  fmt::format("{}: the folder is in use by process {}; wait for it, or give --out "
                              "another folder",
                              file.parent_path().string(), length > 0 ? holder.data() : "?"));
  }
  const std::string pid = std::to_string(::getpid());
  if (::ftruncate(fd_, 0) != 0 || ::write(fd_, pid.data(), pid.size()) < 0) {
    const std::string why = std::strerror(errno);
    ::close(fd_);
    throw DiskError(fmt::format("{}: cannot be written: {}", file.string(), why));
  }
}

RunLock::~RunLock() { ::close(fd_); }

bool is_locked(const std::filesystem::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool taken = ::flock(fd, LOCK_SH | LOCK_NB) != 0;
  ::close(fd);
  return taken;
}

}  // namespace millwear::orchestrator
