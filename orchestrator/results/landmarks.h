#pragma once
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"
#include "orchestrator/charge/charge_of_cycle.h"

namespace millwear::orchestrator {

/// Where the charge stood in the measurement of one cycle, see wear/charge/charge_landmarks.h.
struct LandmarksRow {
  int cycle;
  double shoulder;  ///< [rad]
  double bulk_toe;  ///< [rad]
  double head_x;    ///< [m]
  double head_z;    ///< [m]
  double centre_x;  ///< [m]
  double centre_z;  ///< [m]
};

/// The columns of `landmarks.csv`.
[[nodiscard]] std::span<const CsvColumn<LandmarksRow>> landmark_columns();

/// The bytes of `landmarks.csv`, a line a cycle that recorded its charge.
[[nodiscard]] std::string landmarks_csv(const std::vector<ChargeOfCycle>& cycles);

}  // namespace millwear::orchestrator
