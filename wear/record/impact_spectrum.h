#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// Energy classes of the spectra: ten to the decade from 1e-9 to 1e5 J, evenly in the logarithm.
inline constexpr Eigen::Index energy_classes = 140;
inline constexpr double least_energy = 1e-9;
inline constexpr double energy_classes_per_decade = 10.0;

/// Limits of the energy classes [J], size energy_classes + 1.
[[nodiscard]] Eigen::VectorXd energy_edges();

/// The class i of an energy [J], edges[i] <= energy < edges[i + 1]; what lies beyond belongs to the
/// first or the last.
[[nodiscard]] Eigen::Index energy_class(double energy);

/// How many collisions dissipated how much, a row an energy class, a column a group: the particle
/// class for collisions with the liner, a pair of classes for those between particles.
struct ImpactSpectrum {
  Eigen::MatrixXd normal_events;  ///< collisions by the energy dissipated normal to the contact [-]
  Eigen::MatrixXd normal_energy;  ///< that energy, summed [J]
  Eigen::MatrixXd shear_events;   ///< collisions by the energy dissipated along the contact [-]
  Eigen::MatrixXd shear_energy;   ///< [J]
  Eigen::VectorXd unfinished;     ///< collisions not seen whole, which are in none of the above [-]
};

[[nodiscard]] ImpactSpectrum empty_spectrum(Eigen::Index groups);

/// Counts one whole collision with the energies [J] it dissipated.
void add_collision(ImpactSpectrum& spectrum, Eigen::Index group, double normal_energy,
                   double shear_energy);

void add_spectrum(ImpactSpectrum& sum, const ImpactSpectrum& more);

/// Column of the pair of particle classes (a, b), in either order, among the
/// classes (classes + 1) / 2 pairs (0,0), (0,1), ... (1,1), (1,2), ...
[[nodiscard]] Eigen::Index pair_group(Eigen::Index a, Eigen::Index b, Eigen::Index classes);
[[nodiscard]] Eigen::Index pair_groups(Eigen::Index classes);

}  // namespace millwear::wear
