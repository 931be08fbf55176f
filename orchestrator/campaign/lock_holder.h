#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace millwear::orchestrator {

/// The process that holds a folder.
struct LockHolder {
  std::string host;
  long process;
  std::string boot;  ///< the host's boot ID; after another boot the process is gone
  bool operator==(const LockHolder&) const = default;
};

[[nodiscard]] LockHolder this_process();

/// "HOST PROCESS BOOT", as a lock file keeps it.
[[nodiscard]] std::string written(const LockHolder& holder);
[[nodiscard]] std::optional<LockHolder> lock_holder_from(std::string_view text);

/// Whether it is known that the holder is gone: its process on this host, or the boot that it ran
/// in.
[[nodiscard]] bool is_gone(const LockHolder& holder);

/// "process 4711 on node7", or "another process" where the holder is not known.
[[nodiscard]] std::string spoken(const std::optional<LockHolder>& holder);

}  // namespace millwear::orchestrator
