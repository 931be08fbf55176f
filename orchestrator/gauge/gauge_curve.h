#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "mill/base/length_unit.h"
#include "mill/liner/curve_csv.h"

namespace millwear::orchestrator {

/// A file of a gauge, a scanner or a drawing office.
struct CurveFile {
  std::filesystem::path path;
  std::optional<LengthUnit> unit;    ///< in place of what the file says
  std::optional<std::string> layer;  ///< of a DXF
};

/// The largest file that is read [bytes].
inline constexpr std::size_t largest_curve_file = 16 * 1024 * 1024;

/// Reads a curve:
/// - a table with the columns xi and eta (the master frame) or x and y (mill/liner/curve_csv.h);
/// - a DXF (by the ending) with one open polyline, or one on `layer`; its unit is `unit`, else the
///   drawing's.
/// Throws InputError (file:line for a CSV), which says what would be right.
[[nodiscard]] CurveRows read_gauge_curve(const CurveFile& file);

}  // namespace millwear::orchestrator
