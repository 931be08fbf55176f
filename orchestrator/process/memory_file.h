#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace millwear::orchestrator {

/// A file in memory, to hand to another program. It is gone with this object. Every function throws
/// DiskError where memory or the system refuses.
class MemoryFile {
 public:
  /// `subject` names it in messages, e.g. "a plot".
  explicit MemoryFile(std::string subject);
  MemoryFile(std::string subject, std::string_view content);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The path under which a program of the same user can open it.
  [[nodiscard]] std::filesystem::path path() const;
  [[nodiscard]] std::string content() const;

 private:
  std::string subject_;
  int descriptor_;
};

}  // namespace millwear::orchestrator
