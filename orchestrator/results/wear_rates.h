#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"

namespace millwear::orchestrator {

/// The wear of one bin of one cycle's liner by one mechanism of a law.
struct WearRateRow {
  int cycle;
  int mechanism;            ///< from 0, in the order of the case
  std::string law;          ///< its name in the case file
  int bin;                  ///< from 0 at the trailing sector edge
  double arc_length;        ///< of the bin's centre along the cycle's liner [m]
  double depth_rate;        ///< as sampled, not smoothed [m/s of milling]
  double depth_rate_error;  ///< its standard error from the time blocks [m/s]
};

/// The columns of the file.
[[nodiscard]] std::span<const CsvColumn<WearRateRow>> wear_rate_columns();

/// The bytes of the file; the same rows always give the same bytes.
[[nodiscard]] std::string wear_rates_csv(const std::vector<WearRateRow>& rows);

/// Reads it back. Throws DiskError or ResultRejected (file:line).
[[nodiscard]] std::vector<WearRateRow> read_wear_rates_csv(const std::filesystem::path& path);

}  // namespace millwear::orchestrator
