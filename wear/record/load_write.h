#pragma once
#include <filesystem>
#include <span>

#include "wear/record/liner_record.h"
#include "wear/record/load_store.h"

namespace millwear::wear {

/// Writes a record as an HDF5 file, the same bytes for the same record. The file is built in memory
/// and written in one go: HDF5 itself can hide a full disk. Writes straight to `path`:
/// publishing it (beside, fsync, rename) is the caller's. Throws DiskError where that fails.
void write_record(const std::filesystem::path& path, const LinerRecord& record);

/// The loads of many cycles, a group `cycle_000` for each. Throws likewise.
void write_loads(const std::filesystem::path& path, std::span<const StoredLoad> loads);

}  // namespace millwear::wear
