#pragma once
#include <array>
#include <cstddef>

namespace millwear::recorder {

enum class RollingResistance { constant_torque, spring };  // LIGGGHTS's `cdt` and `epsd2`

/// Whether the springs of contacts go on by a time step. In the step that sets up a run they stay.
enum class Springs { advance, stay };

/// Contacts of two spheres each, side by side in memory, so that the processor's vector units
/// evaluate several at once. What lies in places that are not used does not matter.
struct Contacts {
  static constexpr std::size_t count = 16;
  using Values = std::array<double, count>;
  using Vectors = std::array<Values, 3>;

  Vectors apart;                  ///< from the second centre to the first [m]
  Vectors approach;               ///< velocity of the first centre less that of the second [m/s]
  std::array<Vectors, 2> spin;    ///< [rad/s]
  std::array<Values, 2> radius;   ///< their sum is above the distance of the centres [m]
  Values reduced_mass;            ///< [kg]
  Values effective_young;         ///< E* = 1 / ((1 - nu1^2) / E1 + (1 - nu2^2) / E2) [Pa]
  Values effective_shear;         ///< G* = 1 / ((2 - nu1) / G1 + (2 - nu2) / G2) [Pa]
  Values damping;                 ///< beta = ln e / sqrt(ln^2 e + pi^2) of the restitution e [-]
  Values sliding_friction;        ///< [-]
  Values rolling_friction;        ///< [-]
  Vectors spring;                 ///< tangential; goes on [m]
  Vectors rolling_spring;         ///< torque of the rolling spring, where it is one; goes on [N m]
  Vectors force;                  ///< found: on the first, its reverse on the second [N]
  std::array<Vectors, 2> torque;  ///< found [N m]
};

/// The force of Hertz with damping that keeps the restitution, a tangential spring that slides at
/// the limit of friction, and rolling friction:
///
///     Fn = 4/3 E* sqrt(R d) d - 2 sqrt(5/6) |beta| sqrt(2 E* sqrt(R d) m) vn
///     Ft = -kt s - 2 sqrt(5/6) |beta| sqrt(kt m) vt,   kt = 8 G* sqrt(R d),   |kt s| <= mu |Fn|
///     Mr = mu_r R (4/3 E* sqrt(R d) d)  (constant torque),
///          or a spring of stiffness kt R^2 up to mu_r R |Fn|
///
/// R and m are the reduced radius and mass, d the overlap, vn the speed of the centres apart, vt
/// the slip at the contact and s its integral, kept tangential. Mr acts against the relative spin
/// without its part about the normal. Where a contact slides, Ft is mu |Fn| along the spring. This
/// is LIGGGHTS 3.8's `model hertz tangential history rolling_friction cdt|epsd2` operation by
/// operation, so that all results have its bits. Source: LIGGGHTS's manual, gran_model_hertz,
/// gran_tangential_history, gran_rolling_friction_cdt and _epsd2.
void find_hertz_forces(Contacts& contacts, RollingResistance rolling, double time_step,
                       Springs springs);

}  // namespace millwear::recorder
