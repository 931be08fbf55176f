#pragma once
#include "mill/case/case.h"

namespace millwear {

/// Time a Rayleigh wave takes around half a sphere [s]:
///     t_R = pi R sqrt(rho / G) / (0.1631 nu + 0.8766).
/// Source: Li, Xu and Thornton (2005), Powder Technology 160, 219.
[[nodiscard]] double rayleigh_time(double radius, double density, double shear_modulus,
                                   double poisson_ratio);

/// Least Rayleigh time of the charge's classes, with softened moduli [s].
[[nodiscard]] double shortest_rayleigh_time(const Case& mill);

/// How the mill's turning is cut into time steps: a pitch takes a whole number of steps, so that a
/// worn mesh can take the place of the old one where they coincide.
struct StepPlan {
  double time_step;  ///< [s]
  long steps_per_pitch;
  [[nodiscard]] long steps_per_revolution(int rows) const { return steps_per_pitch * rows; }
};

/// The longest step not above `rayleigh_fraction` of the shortest Rayleigh time (nor above
/// `longest_time_step`) of which a pitch takes a whole number. A wanted `time_step` stands in the
/// place of that share, and is cut to a whole number the same way.
[[nodiscard]] StepPlan plan_steps(const Case& mill);

}  // namespace millwear
