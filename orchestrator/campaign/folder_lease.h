#pragma once
#include <filesystem>
#include <optional>
#include <thread>

#include "orchestrator/campaign/lock_holder.h"

namespace millwear::orchestrator {

/// Holds a folder on a file system without locks, by a file that names the holder and that this
/// process touches every few seconds. It goes with its object. What a killed process left is taken
/// over at once on its own host, elsewhere once it has not been touched for five minutes.
class FolderLease {
 public:
  /// Throws Failure (exit code 7), with the holder, where another holds it, and DiskError where the
  /// file cannot be made.
  explicit FolderLease(std::filesystem::path file);
  ~FolderLease();
  FolderLease(const FolderLease&) = delete;
  FolderLease& operator=(const FolderLease&) = delete;

 private:
  std::filesystem::path file_;
  std::jthread touching_;
};

/// Who holds a lease now.
[[nodiscard]] std::optional<LockHolder> lease_holder(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
