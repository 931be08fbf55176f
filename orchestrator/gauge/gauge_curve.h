#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/base/length_unit.h"
#include "mill/liner/curve_csv.h"

namespace millwear::orchestrator {

/// A file of a gauge, a scanner or a drawing office.
struct CurveFile {
  std::filesystem::path path;
  std::optional<LengthUnit> unit;    ///< in place of what the file says
  std::optional<std::string> layer;  ///< of a DXF
};

struct GaugeCurve {
  CurveRows rows;
  std::vector<std::string> drawn_as;  ///< the pieces of a drawing's curve
  std::vector<std::string> left_out;  ///< of a drawing
};

/// The largest table that is read [bytes].
inline constexpr std::size_t largest_curve_file = 16 * 1024 * 1024;

/// Reads a curve:
/// - a table with the columns xi and eta (the master frame) or x and y (mill/liner/curve_csv.h);
/// - a DXF (by the ending), of which it takes the open curve (meshgen/drawing/drawing_profile.h);
/// its
///   unit is `unit`, else the drawing's.
/// Throws InputError (file:line for a CSV), which says what would be right.
[[nodiscard]] GaugeCurve read_gauge_curve(const CurveFile& file);

}  // namespace millwear::orchestrator
