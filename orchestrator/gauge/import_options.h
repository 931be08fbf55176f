#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "orchestrator/gauge/gauge_curve.h"

namespace millwear::orchestrator {

/// How a gauge's curve is brought to the master lifter.
enum class AlignmentMode {
  by_file,  ///< `none` for columns xi_m, eta_m, else `fit`
  none,     ///< it is in the master frame
  ends,     ///< by its two ends
  fit,      ///< by its unworn parts
};

/// What the user asked `millwear import` for.
struct ImportOptions {
  std::optional<std::filesystem::path> curve;
  double hours = 0.0;  ///< operating hours of the reading
  std::optional<LengthUnit> unit{};
  std::optional<std::string> layer{};  ///< of a DXF
  AlignmentMode align = AlignmentMode::by_file;
  bool mirror = false;
  std::optional<std::filesystem::path> reference{};
  double error_mm = 1.0;
  std::optional<double> height_mm{};
  std::optional<double> plate_mm{};
};

}  // namespace millwear::orchestrator
