#pragma once
#include <filesystem>
#include <vector>

#include "wear/record/liner_record.h"
#include "wear/record/load_store.h"

namespace millwear::wear {

/// Reads a file of `write_record`. Throws DiskError where the file cannot be opened, ResultRejected
/// where it is no wall load, of another version, or damaged.
[[nodiscard]] LinerRecord read_record(const std::filesystem::path& path);

/// The load alone of such a file.
[[nodiscard]] WallLoad read_load(const std::filesystem::path& path);

/// The loads of a file of `write_loads`. Throws likewise.
[[nodiscard]] std::vector<StoredLoad> read_loads(const std::filesystem::path& path);

}  // namespace millwear::wear
