#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "orchestrator/app/common_options.h"
#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// What `millwear compare` is told.
struct CompareOptions {
  CommonOptions common;
  std::vector<std::filesystem::path> campaigns;   ///< two or more folders, in place of the case
  std::optional<std::filesystem::path> page;      ///< to be written of them
  std::vector<std::filesystem::path> outs;        ///< none: runs/NAME; two or more: repeats
  std::optional<std::filesystem::path> csv;       ///< to be written
  std::optional<std::filesystem::path> readings;  ///< folder of the gauge readings
  std::vector<std::filesystem::path> compared_profiles;  ///< none, or two
  std::optional<double> calibrate_until;  ///< instead of the case's [h]; 0 for not at all
  std::optional<GaugeOn> gauge_on;
  std::optional<std::filesystem::path> plot;  ///< to be written
};

void add_options(CLI::App& verb, CompareOptions& options);

/// Compares the campaign with the readings, two profiles, or campaigns side by side.
void compare_verb(const CompareOptions& options);

}  // namespace millwear::orchestrator
