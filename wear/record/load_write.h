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

/// A load as `write_loads` stores it. Throws DiskError where HDF5 fails.
[[nodiscard]] PackedLoad packed(const StoredLoad& stored);

/// The loads of many cycles, a group `cycle_000` for each; the same bytes for the same loads,
/// packed before or not. Throws likewise.
void write_loads(const std::filesystem::path& path, std::span<const StoredLoad> loads);
void write_loads(const std::filesystem::path& path, std::span<const PackedLoad> loads);

}  // namespace millwear::wear
