#pragma once
#include <filesystem>

namespace millwear::orchestrator {

/// Syncs every file of a folder and lists their hashes in its file `.hashes`. Throws DiskError.
void seal_folder(const std::filesystem::path& folder);

/// Whether a folder is as `seal_folder` left it, by the hashes of its files.
[[nodiscard]] bool is_as_sealed(const std::filesystem::path& folder);

/// Its list of hashes, which is none of the files that it lists.
inline constexpr const char* folder_hashes_file = ".hashes";

}  // namespace millwear::orchestrator
