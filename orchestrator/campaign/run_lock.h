#pragma once
#include <filesystem>

namespace millwear::orchestrator {

/// Holds a run folder for this process alone. The lock is the kernel's (flock) and goes with the
/// process however it ends, so nothing stale is ever left.
class RunLock {
 public:
  /// Throws Failure (exit code 7), with the holder's process, if the folder is in use.
  explicit RunLock(const std::filesystem::path& file);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  int fd_;
};

/// Whether some process holds the lock now.
[[nodiscard]] bool is_locked(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
