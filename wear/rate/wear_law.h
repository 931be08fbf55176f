#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/case/wear_mechanism.h"
#include "mill/load/wall_load.h"

namespace millwear::wear {

/// A sum of wear laws as weights of what a load has accumulated: worn volume
///     dV/dt = sum over measures m and particle classes c of k(m, c) dE(m, c)/dt,
/// and a depth rate that needs no load. docs/physics.md has each law, its source and its range.
struct LawWeights {
  Eigen::MatrixXd per_energy;  ///< k, measure_count x particle classes [1/Pa], >= 0
  double corrosion;            ///< depth lost everywhere [m/s], >= 0
};

/// The measure that a law goes with. Throws std::logic_error for corrosion, which has none.
[[nodiscard]] Measure measure_of(WearLaw law);

/// The weights of all mechanisms for the classes of a charge, and of one alone. They add: the
/// weights, and the rates, of the whole law are the sum of those of its mechanisms.
[[nodiscard]] LawWeights weights_of(const std::vector<WearMechanism>& mechanisms,
                                    const std::vector<ParticleClass>& classes);
[[nodiscard]] LawWeights weights_of(const WearMechanism& mechanism,
                                    const std::vector<ParticleClass>& classes);

/// Wear depth rate of each bin [m/s of milling], size = load.bins(), never below zero:
///     corrosion + sum k(m, c) E(m, c) / (A rows T),   A the bin's area on one lifter [m2],
/// E the measure [J] over `rows` lifters and `duration` T seconds.
///
/// Normal and shear dissipation of a bin can be below zero: an elastic force gives back on one bin
/// what it took on another. No steel grows, so such a bin counts as zero, and the other bins of
/// that measure and class are multiplied by one factor that keeps their sum over the profile; where
/// the sum itself is not above zero, the class wears nothing. Being done before the weights, this
/// leaves the law linear in its coefficients.
/// Throws InputError if a bin has no area, the load no rows or duration, or other classes than the
/// weights.
[[nodiscard]] Eigen::VectorXd depth_rate(const LawWeights& weights, const WallLoad& load);

/// The same from each time block alone, over the block's own duration T / block_count [m/s],
/// load.bins() x load.block_count. The mean over the blocks is `depth_rate`. Blocks are replicates
/// for the scatter and are not cut, but shifted by what the cut moved the mean: a single block may
/// be below zero.
[[nodiscard]] Eigen::MatrixXd depth_rate_by_block(const LawWeights& weights, const WallLoad& load);

}  // namespace millwear::wear
