#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear calibrate` is told.
struct CalibrateOptions {
  CommonOptions common;
  std::filesystem::path out;                      ///< empty: runs/NAME
  std::optional<std::filesystem::path> csv;       ///< to be written
  std::optional<std::filesystem::path> readings;  ///< folder of the gauge readings
  std::optional<double> until;                    ///< fit to readings up to here only [h]
};

void add_options(CLI::App& verb, CalibrateOptions& options);

/// Fits the coefficients to the readings.
void calibrate_verb(const CalibrateOptions& options);

}  // namespace millwear::orchestrator
