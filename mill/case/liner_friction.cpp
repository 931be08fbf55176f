#include "mill/case/liner_friction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mill/case/case.h"

namespace millwear {
namespace {

double shear_compliance(const Case& mill, std::size_t material) {
  return (2.0 - mill.materials.at(material).poisson_ratio) / softened_shear_modulus(mill, material);
}

double damping_constant(const Case& mill, const ParticleClass& kind, double restitution) {
  const double shear_modulus =
      1.0 / (shear_compliance(mill, kind.material) + shear_compliance(mill, mill.liner_material));
  const double mass = mill.materials.at(kind.material).density * sphere_volume(kind.diameter);
  const double decrement = -std::log(restitution);
  const double share = decrement / std::hypot(decrement, std::numbers::pi);
  const double stiffness_constant = 8.0 * shear_modulus * std::sqrt(0.5 * kind.diameter);
  return 2.0 * std::sqrt(5.0 / 6.0) * share * std::sqrt(stiffness_constant * mass);
}

}  // namespace

std::vector<LinerFriction> liner_friction(const Case& mill) {
  std::vector<LinerFriction> classes;
  for (const auto& kind : mill.charge.classes) {
    const auto& pair = pair_of(mill, kind.material, mill.liner_material);
    classes.push_back({pair.sliding_friction, damping_constant(mill, kind, pair.restitution)});
  }
  return classes;
}

double tangential_damping(const LinerFriction& friction, double overlap) {
  return friction.damping_constant * std::pow(std::max(0.0, overlap), 0.25);
}

}  // namespace millwear
