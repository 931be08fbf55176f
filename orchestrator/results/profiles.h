#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"

namespace millwear::orchestrator {

/// The liner's surface after one geometry step, in the master frame (see
/// mill/liner/liner_profile.h).
struct ProfileRow {
  int cycle;
  int step;
  double operating_hours;              ///< since the liner was new [h]
  std::vector<Eigen::Vector2d> nodes;  ///< (xi, eta) [m]
  /// Standard error of the surface at every node, along its normal [m]; NaN where unknown.
  std::vector<double> depth_error;
};

/// A line of `profiles.csv`: one node of a profile.
struct ProfileNodeRow {
  int cycle;
  int step;
  double operating_hours;
  int node;
  double xi;           ///< [m]
  double eta;          ///< [m]
  double depth_error;  ///< [m]
};

/// The columns of `profiles.csv`.
[[nodiscard]] std::span<const CsvColumn<ProfileNodeRow>> profile_columns();

/// The bytes of `profiles.csv`, a line a node; the same rows always give the same bytes.
[[nodiscard]] std::string profiles_csv(const std::vector<ProfileRow>& rows);

/// Reads `profiles.csv` back. Throws DiskError or ResultRejected (file:line), also where the nodes
/// of a profile are not numbered 0, 1, 2, ...
[[nodiscard]] std::vector<ProfileRow> read_profiles_csv(const std::filesystem::path& path);

}  // namespace millwear::orchestrator
