#include "mill/case/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace millwear {

double rayleigh_time(double radius, double density, double shear_modulus, double poisson_ratio) {
  return std::numbers::pi * radius * std::sqrt(density / shear_modulus) /
         (0.1631 * poisson_ratio + 0.8766);
}

double shortest_rayleigh_time(const Case& mill) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const ParticleClass& c : mill.charge.classes) {
    const Material& material = mill.materials.at(c.material);
    shortest = std::min(
        shortest, rayleigh_time(0.5 * c.diameter, material.density,
                                softened_shear_modulus(mill, c.material), material.poisson_ratio));
  }
  return shortest;
}

StepPlan plan_steps(const Case& mill) {
  const double wanted =
      mill.dem.time_step.value_or(mill.dem.rayleigh_fraction * shortest_rayleigh_time(mill));
  const double longest = std::min(wanted, mill.dem.longest_time_step.value_or(wanted));
  const double pitch_time = mill.liner.sector.pitch() / mill.speed;
  const long steps = std::max(1L, static_cast<long>(std::ceil(pitch_time / longest)));
  return {pitch_time / static_cast<double>(steps), steps};
}

}  // namespace millwear
