#include "orchestrator/campaign/run_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>

#include "mill/base/failure.h"
#include "orchestrator/campaign/folder_lease.h"
#include "orchestrator/campaign/lock_holder.h"
#include "orchestrator/process/child_process.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds between_tries{500};

fs::path lease_beside(const fs::path& lock) { return lock.string() + ".lease"; }

std::string text_in(int fd) {
  std::array<char, 512> text{};
  const ssize_t length = ::pread(fd, text.data(), text.size(), 0);
  return {text.data(), length > 0 ? static_cast<std::size_t>(length) : 0};
}

}  // namespace

void RunLock::take_now(const fs::path& file) {
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK)
    throw Failure(
        ExitCode::locked,
        fmt::format("{}: the folder is in use by {}; wait for it, or give --out another folder",
                    file.parent_path().string(), spoken(lock_holder_from(text_in(fd_)))));
  lease_ = std::make_unique<FolderLease>(lease_beside(file));
}

void RunLock::take(const fs::path& file, std::chrono::steady_clock::time_point until) {
  for (;;) {
    try {
      return take_now(file);
    } catch (const Failure& failure) {
      if (failure.exit_code != ExitCode::locked || std::chrono::steady_clock::now() >= until) throw;
    }
    stop_if_interrupted();
    std::this_thread::sleep_for(between_tries);
  }
}

RunLock::RunLock(const fs::path& file, std::chrono::seconds patience)
    : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (fd_ < 0)
    throw DiskError(fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno)));
  try {
    take(file, std::chrono::steady_clock::now() + patience);
    const std::string holder = written(this_process());
    if (::ftruncate(fd_, 0) != 0 || ::pwrite(fd_, holder.data(), holder.size(), 0) < 0)
      throw DiskError(
          fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

RunLock::~RunLock() { ::close(fd_); }

bool is_locked(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool is_free = ::flock(fd, LOCK_SH | LOCK_NB) == 0;
  const bool has_locks = is_free || errno == EWOULDBLOCK;
  ::close(fd);
  return has_locks ? !is_free : lease_holder(lease_beside(file)).has_value();
}

}  // namespace millwear::orchestrator
