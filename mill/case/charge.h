#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace millwear {

/// Spheres of one material and one size.
struct ParticleClass {
  std::size_t material;  ///< index into Case::materials
  double diameter;       ///< [m]
  std::size_t count;     ///< in the simulated slice
};

/// One size class of a sieve analysis: the share of the solid volume retained on `size`.
struct SieveClass {
  double size;      ///< lower limit of the class, taken as the diameter [m]
  double retained;  ///< share by volume within its material, any unit (they are normalised)
};

/// Solid volume [m3] and mass [kg] of a charge, and number of particles.
struct ChargeTotals {
  std::size_t particles;
  double solid_volume;
  double mass;
};

[[nodiscard]] double sphere_volume(double diameter);

/// Diameters [m] of the largest and of the smallest particles; there is at least one class.
[[nodiscard]] double largest_diameter(const std::vector<ParticleClass>& classes);
[[nodiscard]] double smallest_diameter(const std::vector<ParticleClass>& classes);

/// The class of a particle of this material and diameter [m], to a millionth of it; none where no
/// class fits.
[[nodiscard]] std::optional<std::size_t> class_of(const std::vector<ParticleClass>& classes,
                                                  std::size_t material, double diameter);

/// Counts of each class for a wanted solid volume [m3] of one material, after the sieve classes
/// below `truncate_below` [m] are dropped and the rest scaled up to the same volume:
///     N_i = V w_i / (pi d_i^3 / 6),   w_i = retained_i / sum of retained, rounded to nearest.
/// Throws InputError if nothing is left.
[[nodiscard]] std::vector<ParticleClass> counts_for_volume(
    std::size_t material, const std::vector<SieveClass>& distribution, double solid_volume,
    double truncate_below);

}  // namespace millwear
