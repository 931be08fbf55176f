#include "recorder/pairs/hertz_contacts.h"

#include <cmath>

namespace millwear::recorder {
namespace {

// Sums in LIGGGHTS's order.
using Vector = std::array<double, 3>;

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector times(double factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector tangential(const Vector& a, const Vector& normal) {
  return difference(a, times(dot(a, normal), normal));
}
Vector either(bool first, const Vector& a, const Vector& b) {
  return {first ? a[0] : b[0], first ? a[1] : b[1], first ? a[2] : b[2]};
}

Vector of(const Contacts::Vectors& vectors, std::size_t n) {
  return {vectors[0][n], vectors[1][n], vectors[2][n]};
}
void set(Contacts::Vectors& vectors, std::size_t n, const Vector& value) {
  vectors[0][n] = value[0];
  vectors[1][n] = value[1];
  vectors[2][n] = value[2];
}

/// One contact. Without a branch, that several are evaluated at once: where there is a choice, both
/// are worked out. GCC evaluates them one by one if the loop is given a bool.
template <RollingResistance rolling>
[[gnu::always_inline]] inline void set_forces(Contacts& c, std::size_t n, double time_step,
                                              Springs springs) {
  const bool advance = springs == Springs::advance;
  constexpr double root_of_five_sixths = 0.91287092917527685576161630466800355658790782499663875;
  const Vector apart = of(c.apart, n);
  const double distance = length(apart);
  const double inverse = 1.0 / distance;
  const Vector normal = times(inverse, apart);
  const double radius_a = c.radius[0][n];
  const double radius_b = c.radius[1][n];
  const double overlap = radius_a + radius_b - distance;
  const double arm_a = radius_a - 0.5 * overlap;
  const double arm_b = radius_b - 0.5 * overlap;

  const Vector spin_a = of(c.spin[0], n);
  const Vector spin_b = of(c.spin[1], n);
  const Vector approach = of(c.approach, n);
  const double normal_velocity = dot(approach, normal);
  const Vector spins = times(inverse, sum(times(arm_a, spin_a), times(arm_b, spin_b)));
  const Vector slip =
      difference(difference(approach, times(normal_velocity, normal)), cross(spins, apart));

  const double reduced_radius = radius_a * radius_b / (radius_a + radius_b);
  const double contact_radius = std::sqrt(reduced_radius * overlap);
  const double young = c.effective_young[n];
  const double stiffness = 4. / 3. * young * contact_radius;
  const double shear_stiffness = 8. * c.effective_shear[n] * contact_radius;
  const double damping = -2. * root_of_five_sixths * c.damping[n];
  const double mass = c.reduced_mass[n];
  const double normal_damping = damping * std::sqrt(2. * young * contact_radius * mass);
  const double normal_force = -normal_damping * normal_velocity + stiffness * overlap;

  Vector spring = of(c.spring, n);
  spring = either(advance, tangential(sum(spring, times(time_step, slip)), normal), spring);
  const Vector elastic = times(-1.0, times(shear_stiffness, spring));
  const double elastic_size = shear_stiffness * length(spring);
  const double limit = c.sliding_friction[n] * std::abs(normal_force);
  const bool slides = elastic_size > limit;
  const Vector sliding = times(limit / elastic_size, elastic);
  const double shear_damping = damping * std::sqrt(shear_stiffness * mass);
  const Vector friction = either(slides, sliding, difference(elastic, times(shear_damping, slip)));
  const Vector slid{-sliding[0] / shear_stiffness, -sliding[1] / shear_stiffness,
                    -sliding[2] / shear_stiffness};
  set(c.spring, n, either(slides && advance, slid, spring));

  const Vector relative_spin = difference(spin_a, spin_b);
  Vector resistance;
  if constexpr (rolling == RollingResistance::constant_torque) {
    const double spin = length(relative_spin);
    const double most = c.rolling_friction[n] * stiffness * overlap * reduced_radius;
    resistance = tangential(times(spin > 0.0 ? most / spin : 0.0, relative_spin), normal);
  } else {
    const double rolling_stiffness = shear_stiffness * reduced_radius * reduced_radius;
    const Vector turned = times(time_step * rolling_stiffness, tangential(relative_spin, normal));
    const Vector before = of(c.rolling_spring, n);
    resistance = sum(before, turned);
    const double torque = length(resistance);
    const double most = std::abs(normal_force) * reduced_radius * c.rolling_friction[n];
    resistance = times(torque > most ? most / torque : 1.0, resistance);
    set(c.rolling_spring, n, either(advance, resistance, before));
  }

  const Vector lever = cross(normal, friction);
  set(c.force, n, sum(times(normal_force, normal), friction));
  set(c.torque[0], n, difference(times(-arm_a, lever), resistance));
  set(c.torque[1], n, sum(times(-arm_b, lever), resistance));
}

// The compiler makes one function for each kind of vector unit. All give the same bits.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define MILLWEAR_EACH_VECTOR_UNIT [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define MILLWEAR_EACH_VECTOR_UNIT
#endif

MILLWEAR_EACH_VECTOR_UNIT
void set_forces_with_constant_torque(Contacts& contacts, double time_step, Springs springs) {
#pragma omp simd
  for (std::size_t n = 0; n < Contacts::count; ++n)
    set_forces<RollingResistance::constant_torque>(contacts, n, time_step, springs);
}

MILLWEAR_EACH_VECTOR_UNIT
void set_forces_with_spring(Contacts& contacts, double time_step, Springs springs) {
#pragma omp simd
  for (std::size_t n = 0; n < Contacts::count; ++n)
    set_forces<RollingResistance::spring>(contacts, n, time_step, springs);
}

}  // namespace

void find_hertz_forces(Contacts& contacts, RollingResistance rolling, double time_step,
                       Springs springs) {
  if (rolling == RollingResistance::constant_torque)
    set_forces_with_constant_torque(contacts, time_step, springs);
  else
    set_forces_with_spring(contacts, time_step, springs);
}

}  // namespace millwear::recorder
