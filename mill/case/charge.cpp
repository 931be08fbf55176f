#include "mill/case/charge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mill/base/failure.h"

namespace millwear {

double sphere_volume(double diameter) {
  return std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

double largest_diameter(const std::vector<ParticleClass>& classes) {
  return std::ranges::max(classes, {}, &ParticleClass::diameter).diameter;
}

double smallest_diameter(const std::vector<ParticleClass>& classes) {
  return std::ranges::min(classes, {}, &ParticleClass::diameter).diameter;
}

std::optional<std::size_t> class_of(const std::vector<ParticleClass>& classes, std::size_t material,
                                    double diameter) {
  constexpr double tolerance = 1e-6;
  for (std::size_t c = 0; c < classes.size(); ++c)
    if (classes[c].material == material &&
        std::abs(diameter - classes[c].diameter) < tolerance * classes[c].diameter)
      return c;
  return std::nullopt;
}

std::vector<ParticleClass> counts_for_volume(std::size_t material,
                                             const std::vector<SieveClass>& distribution,
                                             double solid_volume, double truncate_below) {
  double retained = 0.0;
  for (const SieveClass& sieve : distribution) {
    retained += sieve.size >= truncate_below ? sieve.retained : 0.0;
  }
  std::vector<ParticleClass> classes;
  for (const SieveClass& sieve : distribution) {
    if (sieve.size < truncate_below || sieve.retained <= 0.0) {
      continue;
    }
    const double count =
        std::round(solid_volume * sieve.retained / retained / sphere_volume(sieve.size));
    if (!(count <= std::numeric_limits<int>::max())) {
      throw InputError(
          fmt::format("too many particles ({:.3g} of {} m, one mill takes {} at most); raise "
                      "`truncate_below_m`",
                      count, sieve.size, std::numeric_limits<int>::max()));
    }
    if (count >= 1.0) {
      classes.push_back({material, sieve.size, static_cast<std::size_t>(count)});
    }
  }
  if (classes.empty()) {
    throw InputError(
        fmt::format("no particle is left of a distribution ({:.4g} m3 of solid, sizes under {} m "
                    "cut off); lower `truncate_below_m` or raise the filling",
                    solid_volume, truncate_below));
  }
  return classes;
}

}  // namespace millwear
