#include "mill/case/liner_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/case/charge.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

// Steel on steel: G* is the half of G / (2 - nu).
TEST(LinerFriction, DampsAsHertzAndMindlinsContactDoes) {
  Case mill = example_case();
  const ParticleClass& kind = mill.charge.classes.front();
  const Material& steel = mill.materials.at(kind.material);
  ASSERT_EQ(kind.material, mill.liner_material);
  const auto& pair = pair_of(mill, kind.material, mill.liner_material);
  const double radius = 0.5 * kind.diameter;
  const double overlap = 1e-3 * radius;
  const double shear_modulus =
      softened_shear_modulus(mill, kind.material) / (2.0 - steel.poisson_ratio) / 2.0;
  const double stiffness = 8.0 * shear_modulus * std::sqrt(radius * overlap);
  const double logarithm = std::log(pair.restitution);
  const double beta =
      logarithm / std::sqrt(logarithm * logarithm + std::numbers::pi * std::numbers::pi);
  const double mass = steel.density * sphere_volume(kind.diameter);
  const auto friction = liner_friction(mill);
  ASSERT_EQ(friction.size(), mill.charge.classes.size());
  EXPECT_EQ(friction.front().coefficient, pair.sliding_friction);
  const double damping = tangential_damping(friction.front(), overlap);
  EXPECT_NEAR(damping, -2.0 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(stiffness * mass),
              1e-12 * damping);
  EXPECT_EQ(tangential_damping(friction.front(), -1e-9), 0.0);
}

TEST(LinerFriction, HasNoDamperWhereContactsAreElastic) {
  Case mill = example_case();
  for (auto& pair : mill.pairs) pair.restitution = 1.0;
  EXPECT_EQ(tangential_damping(liner_friction(mill).front(), 1e-5), 0.0);
}

}  // namespace
}  // namespace millwear
