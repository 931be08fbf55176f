#pragma once
#include <Eigen/Core>
#include <vector>

#include "wear/calibrate/wear_path.h"

namespace millwear::wear {

/// What a liner has lost by a date, with factors f_m on the coefficients of the mechanisms.
struct PathLoss {
  Eigen::VectorXd lost;        ///< by channel [m2 and m]
  Eigen::MatrixXd taken;       ///< channels x mechanisms: int r_mc dt; lost = taken * factors
  Eigen::MatrixXd per_factor;  ///< channels x mechanisms: d lost / d f_m
};

/// Losses after `time` seconds of milling, >= 0; later than the last liner its last rates are taken
/// to go on. The place A on the path and the losses L_c obey
///     dA/dt = sum f_m pace_m(A),      dL_c/dt = sum f_m r_mc(A).
/// Factors all multiplied by one number reach the same state in the time divided by it.
[[nodiscard]] PathLoss loss_at(const WearPath& path, const Eigen::VectorXd& factors, double time);

/// Time at which the last liner of the path is reached [s]; infinite where the factors stop before.
[[nodiscard]] double time_of_path(const WearPath& path, const Eigen::VectorXd& factors);

}  // namespace millwear::wear
