#pragma once
#include <chrono>
#include <filesystem>
#include <memory>

namespace millwear::orchestrator {

class FolderLease;

/// Holds a run folder for this process alone. The lock is the kernel's (flock) and goes with the
/// process however it ends. Where the file system has no locks, a lease takes its place
/// (folder_lease.h).
class RunLock {
 public:
  /// Waits up to `patience` for a folder that is in use. Throws Failure (exit code 7), with the
  /// holder's process and host, if it still is.
  explicit RunLock(const std::filesystem::path& file, std::chrono::seconds patience = {});
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether the file system has no locks.
  [[nodiscard]] bool is_lease() const { return lease_ != nullptr; }

 private:
  void take_now(const std::filesystem::path& file);
  void take(const std::filesystem::path& file, std::chrono::steady_clock::time_point until);

  int fd_;
  std::unique_ptr<FolderLease> lease_;
};

/// Whether some process holds the lock now.
[[nodiscard]] bool is_locked(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
