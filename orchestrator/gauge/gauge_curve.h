#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace millwear::orchestrator {

enum class LengthUnit { metre, millimetre };

/// A file of a gauge, a scanner or a drawing office.
struct CurveFile {
  std::filesystem::path path;
  std::optional<LengthUnit> unit;    ///< in place of what the file says
  std::optional<std::string> layer;  ///< of a DXF
};

struct GaugeCurve {
  std::vector<Eigen::Vector2d> nodes;  ///< [m]
  bool in_master_frame;                ///< columns xi_m and eta_m
};

/// The largest file that is read [bytes].
inline constexpr std::size_t largest_curve_file = 16 * 1024 * 1024;

/// Reads a curve:
/// - a CSV with the columns `xi_m`, `eta_m` (the master frame) or `x`, `y` (metres, or `unit`), in
///   any order and among others;
/// - a DXF (by the ending) with one open polyline, or one on `layer`; its unit is `unit`, else the
///   drawing's.
/// Throws InputError (file:line for a CSV), which says what would be right.
[[nodiscard]] GaugeCurve read_gauge_curve(const CurveFile& file);

}  // namespace millwear::orchestrator
