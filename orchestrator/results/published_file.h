#pragma once
#include <filesystem>
#include <string_view>

namespace millwear::orchestrator {

/// Puts `bytes` at `path` so that a reader finds the old file or the whole new one, never a part,
/// and so that the new one outlives a power cut: written beside as `.NAME.partial`, synced,
/// renamed, and the folder synced. Throws DiskError with the path and the system's reason; the old
/// file then stays and nothing is left beside it.
void publish(const std::filesystem::path& path, std::string_view bytes);

}  // namespace millwear::orchestrator
