#pragma once
#include <string>

namespace millwear {

/// "millwear 0.1.0 (git 1a2b3c4)".
[[nodiscard]] std::string program_version();

}  // namespace millwear
