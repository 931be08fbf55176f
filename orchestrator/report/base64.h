#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace millwear::orchestrator {

/// Bytes as the text that a page holds them in (RFC 4648).
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace millwear::orchestrator
