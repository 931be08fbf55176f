#pragma once
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "mill/load/wall_load.h"
#include "wear/record/liner_record.h"

namespace millwear::wear {

/// Version and types of the files below; files of another version are refused.
inline constexpr int load_format_version = 4;
inline constexpr std::string_view one_load = "millwear wall load";
inline constexpr std::string_view many_loads = "millwear wall loads";

/// The load of one cycle.
struct StoredLoad {
  int cycle;  ///< >= 0
  WallLoad load;
};

/// Writes a record as an HDF5 file, the same bytes for the same record. The file is built in memory
/// and written in one go: HDF5 itself can hide a full disk. Writes straight to `path`:
/// publishing it (beside, fsync, rename) is the caller's. Throws DiskError where that fails.
void write_record(const std::filesystem::path& path, const LinerRecord& record);

/// Reads it back. Throws DiskError where the file cannot be opened, ResultRejected where it is no
/// wall load, of another version, or damaged.
[[nodiscard]] LinerRecord read_record(const std::filesystem::path& path);

/// The load alone of such a file.
[[nodiscard]] WallLoad read_load(const std::filesystem::path& path);

/// The loads of many cycles, a group `cycle_000` for each.
void write_loads(const std::filesystem::path& path, std::span<const StoredLoad> loads);
[[nodiscard]] std::vector<StoredLoad> read_loads(const std::filesystem::path& path);

}  // namespace millwear::wear
