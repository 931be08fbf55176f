#pragma once
#include <Eigen/Core>
#include <array>

namespace millwear::wear {

/// How a load that is known was measured.
struct SyntheticMill {
  Eigen::Index bins = 160;
  Eigen::Index blocks = 10;
  double events_in_block = 200.0;  ///< mean number of collisions on the whole profile
  double energy_spread = 1.0;      ///< standard deviation of the logarithm of a collision's energy
  double footprint = 3.0;          ///< mean length of a collision's path [bins]
  double corner_share = 0.05;      ///< of the collisions, all in one bin
  double locked_share = 0.0;       ///< of the energy, by twelve balls that stay where they are
  double locked_footprint = 1.0;   ///< of each of them [bins]
};

/// Collisions as a compound Poisson process. The profile has two broad peaks, a corner with a face
/// behind it that the load leaves slowly, and a stretch that nothing touches.
struct SyntheticLoad {
  Eigen::VectorXd edges;              ///< [bins]
  Eigen::VectorXd truth;              ///< expected rate of every bin, mean 1
  Eigen::VectorXd rate;               ///< mean over the blocks
  Eigen::MatrixXd by_block;           ///< bins x blocks
  std::array<Eigen::Index, 3> peaks;  ///< bins of the truth's local maxima, the corner last
};

[[nodiscard]] SyntheticLoad measured(const SyntheticMill& mill, unsigned seed);

}  // namespace millwear::wear
