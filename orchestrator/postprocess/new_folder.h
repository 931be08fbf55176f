#pragma once
#include <filesystem>

namespace millwear::orchestrator {

/// A folder of results that appears whole or not at all: its files are written into a folder beside
/// it, which `publish` renames. What was not published is removed with this object.
class NewFolder {
 public:
  /// Throws Failure (usage) where `folder` exists and holds anything, DiskError where no folder can
  /// be made beside it.
  explicit NewFolder(std::filesystem::path folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& beside() const { return beside_; }

  /// Throws DiskError.
  void publish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path beside_;
};

}  // namespace millwear::orchestrator
