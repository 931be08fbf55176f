#include "recorder/pairs/hertz_contacts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;

constexpr double young = 2.0e7;  // effective [Pa]
constexpr double shear = 6.0e6;  // effective [Pa]
constexpr double restitution = 0.6;
constexpr double sliding = 0.4;
constexpr double rolling = 0.02;
constexpr double radius_a = 0.03;
constexpr double radius_b = 0.05;
constexpr double mass_a = 0.8;
constexpr double mass_b = 2.0;
constexpr double reduced_radius = radius_a * radius_b / (radius_a + radius_b);
constexpr double reduced_mass = mass_a * mass_b / (mass_a + mass_b);

struct Touch {
  double overlap = 1e-4;
  Vector3d normal = Vector3d(1.0, -2.0, 2.0) / 3.0;  ///< from the second to the first
  Vector3d approach = Vector3d::Zero();
  Vector3d spin_a = Vector3d::Zero();
  Vector3d spin_b = Vector3d::Zero();
};

void set(Contacts::Vectors& to, std::size_t n, const Vector3d& value) {
  for (int k = 0; k < 3; ++k) to[k][n] = value[k];
}
Vector3d at(const Contacts::Vectors& vectors, std::size_t n) {
  return {vectors[0][n], vectors[1][n], vectors[2][n]};
}

void place(Contacts& contacts, std::size_t n, const Touch& touch) {
  set(contacts.apart, n, (radius_a + radius_b - touch.overlap) * touch.normal);
  set(contacts.approach, n, touch.approach);
  set(contacts.spin[0], n, touch.spin_a);
  set(contacts.spin[1], n, touch.spin_b);
  contacts.radius[0][n] = radius_a;
  contacts.radius[1][n] = radius_b;
  contacts.reduced_mass[n] = reduced_mass;
  contacts.effective_young[n] = young;
  contacts.effective_shear[n] = shear;
  const double log_of_restitution = std::log(restitution);
  contacts.damping[n] = log_of_restitution / std::hypot(log_of_restitution, std::numbers::pi);
  contacts.sliding_friction[n] = sliding;
  contacts.rolling_friction[n] = rolling;
}

double elastic_force(double overlap) {
  return 4.0 / 3.0 * young * std::sqrt(reduced_radius) * std::pow(overlap, 1.5);
}

class BothRollingResistances : public testing::TestWithParam<RollingResistance> {};
INSTANTIATE_TEST_SUITE_P(HertzContacts, BothRollingResistances,
                         testing::Values(RollingResistance::constant_torque,
                                         RollingResistance::spring));

TEST_P(BothRollingResistances, PressByTheLawOfHertz) {
  Contacts contacts{};
  for (std::size_t n = 0; n < Contacts::count; ++n)
    place(contacts, n, {.overlap = 1e-5 * static_cast<double>(n + 1)});
  find_hertz_forces(contacts, GetParam(), 1e-6, Springs::advance);
  for (std::size_t n = 0; n < Contacts::count; ++n) {
    const double force = elastic_force(1e-5 * static_cast<double>(n + 1));
    EXPECT_NEAR((at(contacts.force, n) - force * Touch{}.normal).norm(), 0.0, 1e-9 * force);
    EXPECT_NEAR(at(contacts.torque[0], n).norm(), 0.0, 1e-12 * force);
  }
}

// The damping was made for it: Antypov and Elliott (2011), EPL 94, 50004.
TEST(HertzContacts, ReboundWithTheRestitution) {
  Contacts contacts{};
  const double time_step = 1e-8;
  Touch touch{.overlap = 0.0, .approach = -Touch{}.normal};
  while (touch.overlap >= 0.0) {
    const double speed = touch.approach.dot(touch.normal);
    touch.overlap -= time_step * speed;
    if (touch.overlap <= 0.0) break;
    place(contacts, 0, touch);
    find_hertz_forces(contacts, RollingResistance::constant_torque, time_step, Springs::advance);
    touch.approach += time_step / reduced_mass * at(contacts.force, 0);
  }
  EXPECT_NEAR(touch.approach.dot(touch.normal), restitution, 1e-4);
}

TEST_P(BothRollingResistances, SlideAtTheLimitOfFriction) {
  Contacts contacts{};
  const Vector3d slip = Vector3d(2.0, 2.0, 1.0) / 3.0;  // at a right angle to the normal
  place(contacts, 0, {.approach = slip});
  const double time_step = 1e-3;  // a millimetre: far beyond the spring's limit
  find_hertz_forces(contacts, GetParam(), time_step, Springs::advance);
  const double normal_force = elastic_force(1e-4);
  const double shear_stiffness = 8.0 * shear * std::sqrt(reduced_radius * 1e-4);
  const Vector3d friction = at(contacts.force, 0) - normal_force * Touch{}.normal;
  EXPECT_NEAR((friction + sliding * normal_force * slip).norm(), 0.0, 1e-9 * normal_force);
  EXPECT_NEAR((at(contacts.spring, 0) - sliding * normal_force / shear_stiffness * slip).norm(),
              0.0, 1e-12);
}

TEST_P(BothRollingResistances, StickWithASpringAndItsDamping) {
  Contacts contacts{};
  const Vector3d slip = 0.01 * Vector3d(2.0, 2.0, 1.0) / 3.0;
  place(contacts, 0, {.approach = slip});
  const double time_step = 1e-6;
  find_hertz_forces(contacts, GetParam(), time_step, Springs::advance);
  const double stiffness = 8.0 * shear * std::sqrt(reduced_radius * 1e-4);
  const double damping =
      2.0 * std::sqrt(5.0 / 6.0) * -contacts.damping[0] * std::sqrt(stiffness * reduced_mass);
  const Vector3d friction = at(contacts.force, 0) - elastic_force(1e-4) * Touch{}.normal;
  const Vector3d expected = -(stiffness * time_step + damping) * slip;
  EXPECT_NEAR((friction - expected).norm(), 0.0, 1e-9 * expected.norm());
}

// Friction acts where the spheres touch, and rolling friction turns both by as much.
TEST_P(BothRollingResistances, KeepTheAngularMomentum) {
  Contacts contacts{};
  const Touch touch{
      .approach = {0.3, -0.1, 0.2}, .spin_a = {5.0, 2.0, -7.0}, .spin_b = {1.0, 8.0, 3.0}};
  place(contacts, 0, touch);
  find_hertz_forces(contacts, GetParam(), 1e-6, Springs::advance);
  const Vector3d from_force = at(contacts.apart, 0).cross(at(contacts.force, 0));
  EXPECT_NEAR((at(contacts.torque[0], 0) + at(contacts.torque[1], 0) + from_force).norm(), 0.0,
              1e-12 * from_force.norm());
}

TEST(HertzContacts, RollWithAConstantTorque) {
  Contacts contacts{};
  // Turning against each other without a slip, and about the normal, which rolling friction leaves.
  const Vector3d axis = Vector3d(2.0, 2.0, 1.0) / 3.0;
  const double arm_a = radius_a - 0.5e-4;
  const double arm_b = radius_b - 0.5e-4;
  place(contacts, 0, {.spin_a = arm_b * axis + 0.001 * Touch{}.normal, .spin_b = -arm_a * axis});
  find_hertz_forces(contacts, RollingResistance::constant_torque, 1e-6, Springs::advance);
  const Vector3d relative = (arm_a + arm_b) * axis + 0.001 * Touch{}.normal;
  const Vector3d torque =
      -rolling * reduced_radius * elastic_force(1e-4) * (arm_a + arm_b) / relative.norm() * axis;
  EXPECT_NEAR((at(contacts.torque[0], 0) - torque).norm(), 0.0, 1e-9 * torque.norm());
  EXPECT_NEAR((at(contacts.torque[1], 0) + torque).norm(), 0.0, 1e-9 * torque.norm());
}

TEST(HertzContacts, RollOnASpringUpToItsLimit) {
  Contacts contacts{};
  const Vector3d axis = Vector3d(2.0, 2.0, 1.0) / 3.0;
  const double arm_a = radius_a - 0.5e-4;
  const double arm_b = radius_b - 0.5e-4;
  const auto roll = [&](std::size_t n, double speed) {
    place(contacts, n, {.spin_a = speed * arm_b * axis, .spin_b = -speed * arm_a * axis});
  };
  roll(0, 1.0);
  roll(1, 1e6);
  const double time_step = 1e-6;
  find_hertz_forces(contacts, RollingResistance::spring, time_step, Springs::advance);
  const double stiffness =
      8.0 * shear * std::sqrt(reduced_radius * 1e-4) * reduced_radius * reduced_radius;
  const double spring = stiffness * (arm_a + arm_b) * time_step;
  const double most = rolling * reduced_radius * elastic_force(1e-4);
  ASSERT_LT(spring, most);
  EXPECT_NEAR((at(contacts.torque[0], 0) + spring * axis).norm(), 0.0, 1e-9 * spring);
  EXPECT_NEAR((at(contacts.torque[0], 1) + most * axis).norm(), 0.0, 1e-9 * most);
  EXPECT_NEAR((at(contacts.rolling_spring, 1) - most * axis).norm(), 0.0, 1e-9 * most);
}

TEST_P(BothRollingResistances, LeaveSpringsThatStay) {
  Contacts contacts{};
  const Vector3d spring(1e-6, 2e-6, -3e-6);
  for (std::size_t n = 0; n < Contacts::count; ++n) {
    place(contacts, n, {.approach = {0.3, -0.1, 0.2}, .spin_a = {5.0, 2.0, -7.0}});
    set(contacts.spring, n, spring);
    set(contacts.rolling_spring, n, spring);
  }
  find_hertz_forces(contacts, GetParam(), 1e-3, Springs::stay);
  for (std::size_t n = 0; n < Contacts::count; ++n) {
    EXPECT_EQ(at(contacts.spring, n), spring);
    EXPECT_EQ(at(contacts.rolling_spring, n), spring);
  }
}

}  // namespace
}  // namespace millwear::recorder
