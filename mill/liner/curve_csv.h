#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/base/length_unit.h"

namespace millwear {

/// What the places of a curve are measured from.
enum class CurveFrame {
  master,  ///< columns xi and eta: the frame of the master lifter (LinerSector)
  own,     ///< columns x and y: any other
};

/// The points of a table, in the order of the file.
struct CurveRows {
  CurveFrame frame;
  std::vector<Eigen::Vector2d> nodes;  ///< [m]
  std::vector<int> lines;              ///< of the nodes in the file
  bool is_whole_pitch;                 ///< the program wrote the file, so it holds a whole pitch
};

/// Reads a table (mill/base/user_table.h) with the columns xi and eta, or x and y, in any order and
/// among others. A column may name its unit: `xi_m`, `x_mm`, `eta [in]`, `Y (cm)`. Without one, x
/// and y are in `unit`, or else in metres, and xi and eta are refused.
/// Throws InputError (file:line) for other columns, a unit that is not that of the file, a value
/// that is no number, and a file of the program's own that is cut off.
[[nodiscard]] CurveRows curve_rows(std::string_view text, const std::filesystem::path& file,
                                   std::optional<LengthUnit> unit = std::nullopt);

}  // namespace millwear
