#pragma once
#include <filesystem>
#include <optional>
#include <set>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear report` is told.
struct ReportOptions {
  CommonOptions common;
  std::filesystem::path out;                      ///< empty: runs/NAME
  std::optional<std::filesystem::path> readings;  ///< folder of the gauge readings
  bool pictures = true;
  std::set<int> picture_cycles{};  ///< with all pictures, besides the first and the last
};

void add_options(CLI::App& verb, ReportOptions& options);

/// Writes the results and the report of the campaign so far.
void report_verb(const ReportOptions& options);

}  // namespace millwear::orchestrator
