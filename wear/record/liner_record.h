#pragma once
#include <Eigen/Core>
#include <optional>

#include "mill/load/wall_load.h"
#include "wear/record/charge_motion.h"
#include "wear/record/charge_position.h"
#include "wear/record/impact_spectrum.h"
#include "wear/record/measurement_goal.h"
#include "wear/record/polar_load.h"

namespace millwear::wear {

/// The contacts between particles over a window of the measurement.
struct PairRecord {
  double duration;             ///< of the window [s]
  ImpactSpectrum spectrum;     ///< a column a pair of particle classes, see `pair_group`
  double normal_dissipation;   ///< int F . v_n dt over all contacts, whole collisions or not [J]
  double shear_dissipation;    ///< int -Ft . v_slip dt [J]
  double rolling_dissipation;  ///< int of the rolling torque on the relative spin [J]
};

/// Everything that one measurement tells of the liner and its charge.
struct LinerRecord {
  WallLoad load;              ///< on bins * cells_per_bin cells
  ChargeAngles angles;        ///< contacts off the profile count too
  ImpactSpectrum spectrum;    ///< collisions with the liner, a column a particle class
  Eigen::MatrixXd triangles;  ///< measure_count x triangles of the mesh, in the order of the STL
  std::optional<PairRecord> pairs{};
  std::optional<MeasurementGoal> goal{};  ///< of a measurement that could go on
  std::optional<ChargeMotion> motion{};   ///< where it was recorded
  std::optional<PolarLoad> polar{};       ///< records of older programs have none
};

/// Sum of two records of the same measurement, e.g. of two ranks that saw different contacts.
/// They differ in nothing but their values (std::logic_error).
[[nodiscard]] LinerRecord sum_of(const LinerRecord& first, const LinerRecord& second);

/// The same for loads alone.
[[nodiscard]] WallLoad sum_of(const WallLoad& first, const WallLoad& second);

/// A load with time blocks added at the end, in which nothing was measured yet.
[[nodiscard]] WallLoad with_blocks(const WallLoad& load, std::size_t block_count);

/// One record from those of two consecutive parts of a measurement. Each has the time blocks from
/// the measurement's beginning, `last` at least as many as `first`, and what was measured in its
/// own part of the time. The collisions between particles are those of the one that has them.
[[nodiscard]] LinerRecord joined(const LinerRecord& first, const LinerRecord& last);

}  // namespace millwear::wear
