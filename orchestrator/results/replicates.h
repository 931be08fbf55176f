#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"

namespace millwear::orchestrator {

/// The liners that the mill may have worn by the end of one geometry step, given the noise of its
/// loads (docs/physics.md, "The band of a life"). A replicate has the same place in every row.
struct ReplicateRow {
  int cycle;
  int step;
  double operating_hours;   ///< since the liner was new [h]
  Eigen::VectorXd heights;  ///< lifter height of each replicate [m]
  Eigen::VectorXd plates;   ///< its least steel over the shell [m]
};

/// The columns of `replicates.csv`.
[[nodiscard]] std::span<const CsvColumn<ReplicateRow>> replicate_columns();

/// The bytes of `replicates.csv`, lengths to a thousandth of a millimetre; the same rows always
/// give the same bytes.
[[nodiscard]] std::string replicates_csv(const std::vector<ReplicateRow>& rows);

/// Reads `replicates.csv` back. Throws DiskError or ResultRejected (file:line), also where the rows
/// have not all as many replicates.
[[nodiscard]] std::vector<ReplicateRow> read_replicates_csv(const std::filesystem::path& path);

}  // namespace millwear::orchestrator
