#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "orchestrator/app/common_options.h"
#include "orchestrator/gauge/gauge_curve.h"
#include "orchestrator/gauge/gauge_import.h"

namespace millwear::orchestrator {

/// What `millwear import` is told.
struct ImportOptions {
  CommonOptions common;
  std::optional<std::filesystem::path> curve;
  double hours = 0.0;  ///< operating hours of the reading
  std::optional<LengthUnit> unit;
  std::optional<std::string> layer;  ///< of a DXF
  AlignmentMode align = AlignmentMode::by_file;
  bool mirror = false;
  std::optional<std::filesystem::path> reference;
  double error_mm = 1.0;
  std::optional<double> height_mm;
  std::optional<double> plate_mm;
  std::optional<std::filesystem::path> readings;  ///< folder of the gauge readings
};

void add_options(CLI::App& verb, ImportOptions& options);

/// Brings a reading into the folder of the readings.
void import_verb(const ImportOptions& options);

}  // namespace millwear::orchestrator
