#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "mill/base/length_unit.h"
#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear new` is told; lengths in the units of the options.
struct NewOptions {
  CommonOptions common;  ///< its case file is the one that is written
  std::optional<std::filesystem::path> drawing;
  std::optional<LengthUnit> unit;
  double shell_diameter = 0.0;  ///< [m]
  int rows = 0;
  std::optional<double> speed_rpm;
  std::optional<double> critical_fraction;
  std::optional<double> height_mm;
  std::optional<double> top_width_mm;
  std::optional<double> face_angle_deg;
  std::optional<double> plate_mm;
  double filling = 0.0;
  std::optional<double> ball_filling;
  std::string balls;
  std::string ore;
};

void add_options(CLI::App& verb, NewOptions& options);

/// Writes a complete case file and says what it amounts to. Writes nothing where the case would be
/// refused, and never over a file that is there.
void new_verb(const NewOptions& options);

}  // namespace millwear::orchestrator
