#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace millwear::orchestrator {

/// Bytes as zlib packs them (RFC 1950); the same bytes for the same version of zlib.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

}  // namespace millwear::orchestrator
