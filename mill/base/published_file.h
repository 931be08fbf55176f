#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace millwear {

/// Puts `bytes` at `path` so that a reader finds the old file or the whole new one, never a part,
/// and so that the new one outlives a power cut: written beside as `.STEM.partial.EXT`, synced,
/// renamed, and the folder synced. Throws DiskError with the path and the system's reason; the old
/// file then stays and nothing is left beside it.
void publish(const std::filesystem::path& path, std::string_view bytes);

/// The same for a file that another library writes: `write` fills the file it is given. What it
/// throws passes through. Throws DiskError if the file comes out empty.
void publish_written(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& beside)>& write);

/// Makes sure a file or folder is on the disk. Throws DiskError.
void sync_path(const std::filesystem::path& path);

}  // namespace millwear
