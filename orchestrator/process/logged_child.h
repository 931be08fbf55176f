#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "orchestrator/process/child_process.h"

namespace millwear::orchestrator {

/// Starts a program without input, in this folder; what it prints is appended to `log`. Throws
/// DiskError where the log cannot be written, ExternalProgramError where the program cannot be
/// started.
[[nodiscard]] std::unique_ptr<ChildProcess> start_logged(const std::vector<std::string>& command,
                                                         const std::filesystem::path& log);

}  // namespace millwear::orchestrator
