#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "wear/calibrate/wear_path.h"

namespace millwear::wear {

/// One thing measured: what a channel has lost since the liner was new. Being cumulative, the
/// errors of two readings are independent.
struct LossObservation {
  std::size_t reading;   ///< which reading it belongs to; one may give several channels
  double time;           ///< of milling since new [s], > 0
  Eigen::Index channel;  ///< of the path
  double lost;           ///< [m2] or [m]
  double error;          ///< standard error [m2] or [m], > 0
};

/// Factors on the coefficients of the mechanisms, none below zero, that fit the observations best.
struct FactorFit {
  Eigen::VectorXd factors;
  double chi_square;       ///< sum of ((measured - fitted) / error)^2
  Eigen::MatrixXd design;  ///< d fitted / d factor over the error, observations x mechanisms
};

/// Minimises chi-square over factors >= 0: Gauss and Newton's steps, each a non-negative
/// least-squares problem, shortened until they lower chi-square. Starts from one common factor, or
/// from `start`. Throws InputError for fewer observations than mechanisms and for a mechanism that
/// wears nothing anywhere on the path, std::logic_error for an observation that cannot be.
[[nodiscard]] FactorFit fit_factors(const WearPath& path,
                                    const std::vector<LossObservation>& observations,
                                    const std::optional<Eigen::VectorXd>& start = {});

/// Factors from all readings but one, by reading 0 ... the largest number, each fit begun from
/// those of all; nothing where the other readings have fewer values than there are mechanisms.
[[nodiscard]] std::vector<std::optional<Eigen::VectorXd>> factors_without_each(
    const WearPath& path, const std::vector<LossObservation>& observations,
    const Eigen::VectorXd& factors);

/// The rival: every channel loses in proportion to time, by weighted least squares. Loss per second
/// by channel, `channels` of them, NaN where a channel has no observation. `without` leaves out one
/// reading.
[[nodiscard]] Eigen::VectorXd straight_line(const std::vector<LossObservation>& observations,
                                            Eigen::Index channels,
                                            std::optional<std::size_t> without = {});

}  // namespace millwear::wear
