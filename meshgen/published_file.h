#pragma once
#include <filesystem>
#include <functional>

namespace millwear::meshgen {

/// Lets `write` fill a file beside `path` (same extension), puts it on the disk and renames it, so
/// `path` is never seen partial. What `write` throws passes through and leaves `path` as it was.
/// Throws DiskError if the file cannot be created, is empty, or cannot be put in place.
void publish(const std::filesystem::path& path,
             const std::function<void(const std::filesystem::path& beside)>& write);

}  // namespace millwear::meshgen
