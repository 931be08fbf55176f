#pragma once
#include <string>

namespace millwear::orchestrator {

/// The name of this machine, or "unknown".
[[nodiscard]] std::string host_name();

}  // namespace millwear::orchestrator
