#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "wear/charge/charge_fields.h"
#include "wear/charge/charge_frames.h"

namespace millwear::wear {

inline constexpr int charge_format_version = 1;
inline constexpr std::string_view charge_file_type = "millwear charge";

/// How the charge looked in one measurement.
struct ChargeRecord {
  ChargeFields fields;
  std::optional<ChargeFrames> frames;  ///< of a chunk but the first there are none
};

/// The record of a measurement from those of two consecutive parts of it.
[[nodiscard]] ChargeRecord joined(ChargeRecord first, const ChargeRecord& last);

/// Writes a record as an HDF5 file (docs/file_formats.md), the same bytes for the same record,
/// straight to `path`: publishing it is the caller's. Throws DiskError where that fails.
void write_charge(const std::filesystem::path& path, const ChargeRecord& record);

/// What is read of a record; the frames are by far the most of it.
enum class ChargeParts { fields, all };

/// Throws DiskError where there is no such file, ResultRejected where it is damaged or of another
/// version.
[[nodiscard]] ChargeRecord read_charge(const std::filesystem::path& path,
                                       ChargeParts parts = ChargeParts::all);

}  // namespace millwear::wear
