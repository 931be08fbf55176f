#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace millwear::orchestrator {

/// A campaign that a study has run.
struct JobRecord {
  std::string point;  ///< name of its folder
  std::string host;
  std::string start;    ///< UTC, as 2026-11-28T14:05:00Z
  double seconds;       ///< that it took
  int exit;             ///< 0: to its end
  std::string command;  ///< to do it by hand
};

/// The time now as `JobRecord::start` has it.
[[nodiscard]] std::string utc_now();

/// Appends a line to the job log and syncs it; writes the head of a new one first. Throws
/// DiskError.
void append_job(const std::filesystem::path& file, const JobRecord& job);

/// How the last job of every point ended; none without a log. A last line that was cut off is left
/// out.
[[nodiscard]] std::map<std::string, int> last_exits(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
