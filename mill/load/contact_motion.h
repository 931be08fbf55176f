#pragma once
#include <Eigen/Core>

#include "mill/case/liner_friction.h"

namespace millwear {

/// How a sphere moves against the wall where it touches.
struct ContactMotion {
  Eigen::Vector3d into_wall;  ///< unit vector from the centre to the contact
  double normal_speed;        ///< closing speed [m/s], positive on approach
  Eigen::Vector3d slip;       ///< of the sphere's surface along the wall [m/s]
  double impact_speed;        ///< of the centre, without the spin [m/s]
  double overlap;             ///< of sphere and wall [m]
};

/// `arm` is the vector from the centre to the contact [m], `radius` the sphere's, `velocity` the
/// centre's against the wall's at the contact [m/s], `spin` [rad/s]. The surfaces meet in the
/// middle of the overlap, as LIGGGHTS has it:
///     v = velocity + (R + |arm|) / 2 spin x n,   v_n = v . n,   v_slip = v - v_n n,   n = arm /
///     |arm|.
[[nodiscard]] ContactMotion contact_motion(const Eigen::Vector3d& arm, double radius,
                                           const Eigen::Vector3d& velocity,
                                           const Eigen::Vector3d& spin);

/// Speed at which the surfaces of a contact move against all that friction can do [m/s], signed:
///     -F_t . v_slip / (mu |F_n|),
/// of a contact that slides the part of v_slip against the force, as LIGGGHTS cuts F_t to mu |F_n|.
/// One that friction holds swings on the spring between the surfaces: the work of loading it comes
/// back negative, so over a swing the sum is zero, also where a swing reaches the limit time and
/// again, as of a particle that is jammed and shakes. What the damper beside the spring takes,
/// `tangential_damping` times v_slip^2, is no sliding and is taken off. Without friction all of
/// v_slip is sliding.
[[nodiscard]] double sliding_speed(const ContactMotion& motion,
                                   const Eigen::Vector3d& tangential_force, double normal_force,
                                   const LinerFriction& friction);

/// |v_slip| of a contact whose force is at the limit of friction [m/s], 0 of one that friction
/// holds. Where the time step resolves a contact this is its `sliding_speed`; beyond that it is
/// what a particle that shakes from limit to limit goes to and fro.
[[nodiscard]] double path_speed(const ContactMotion& motion,
                                const Eigen::Vector3d& tangential_force, double normal_force,
                                const LinerFriction& friction);

/// Finnie's erosion as LIGGGHTS integrates it over a contact [W]: 2 f(a) |v| |F| while the centre
/// approaches (v . arm >= 0), 0 while it leaves, where sin(a) = |v . n| / |v| and
///     f(a) = sin(2 a) - 3 sin(a)^2   for tan(a) <= 1/3,   cos(a)^2 / 3   above.
/// v is the centre's velocity against the wall, without spin; n the wall's unit normal, either way.
/// Source: Finnie (1960), Wear 3, 87; Cleary (1998), Minerals Engineering 11, 1061; LIGGGHTS 3.8.0,
/// fix mesh/surface/stress, wear finnie (which codes 1/3 as 0.33333).
[[nodiscard]] double finnie_power(const Eigen::Vector3d& velocity, const Eigen::Vector3d& arm,
                                  const Eigen::Vector3d& wall_normal, double force);

}  // namespace millwear
