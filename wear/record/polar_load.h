#pragma once
#include <Eigen/Core>
#include <array>

#include "mill/load/wall_load.h"

namespace millwear::wear {

/// Columns of a polar load, of five degrees each.
inline constexpr Eigen::Index polar_columns = 72;

/// The measures that a polar load keeps.
inline constexpr std::array polar_measures{Measure::samples, Measure::normal_dissipation,
                                           Measure::sliding_work};

/// Where around the turn, and where along the profile, the liner takes its load: of each measure a
/// row a bin and a column every five degrees of the angle from six o'clock along the rotation, from
/// -180 to 180. Sums over all lifters, classes and the whole measurement, in the units of
/// `WallLoad`. Contacts that no bin takes are left out, so every measure sums to that of the load.
struct PolarLoad {
  std::array<Eigen::MatrixXd, polar_measures.size()> values;  ///< bins x `polar_columns`
  bool operator==(const PolarLoad&) const = default;
};

[[nodiscard]] PolarLoad no_polar_load(Eigen::Index bins);

/// Column of an angle from six o'clock [rad], -pi ... pi.
[[nodiscard]] Eigen::Index polar_column(double angle_from_six);

/// Adds the load of another rank or part of the time, on the same bins (std::logic_error).
void add_polar(PolarLoad& sum, const PolarLoad& more);

}  // namespace millwear::wear
