#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace millwear {

/// What touches a particle besides the liner.
enum class Company {
  unknown,
  none,    ///< its weight and the liner make all of the force on it
  others,  ///< some other particle
};

/// One particle touching the liner at one instant. Velocities are of the particle against the
/// moving wall at the end of the time step. Archard's law needs the first four
/// members; the others may be left out.
struct WallContact {
  Eigen::Vector3d point;      ///< [m], mill frame
  Eigen::Vector3d into_wall;  ///< unit vector from the particle's centre to the point
  double normal_force;        ///< Fn [N], positive pushes; damping can pull as a contact ends
  double slip_speed;          ///< at which the surfaces slide, with the particle's spin [m/s];
                              ///< of a contact that friction holds, see `sliding_speed`
  double path_speed{};        ///< |v_slip| of one at the limit of friction [m/s], see `path_speed`
  double normal_speed{};      ///< closing speed of the surfaces [m/s], positive on approach
  double impact_speed{};      ///< of the particle's centre, without its spin [m/s]
  double impact_normal_speed{};  ///< its part towards the wall [m/s]; as the contact begins, both
                                 ///< are best known from before the contact's force has acted
  double shear_power{};          ///< work rate of the tangential force on the slip [W]
  double finnie_power{};         ///< 2 f(a) |v| |F| while approaching [W], docs/physics.md
  std::size_t particle_class{};  ///< index into Charge::classes
  std::size_t particle = 1;      ///< its number, from 1
  std::size_t triangle{};        ///< order of the STL file
  Company company = Company::unknown;
};

/// Every wall contact of one instant.
struct WallContacts {
  double time;        ///< since the measurement began [s]
  double mill_angle;  ///< since the stretch began [rad]
  std::vector<WallContact> contacts;
  /// Simulated time that the sample stands for, back from `time` [s]; by default the interval of
  /// the measurement. The last sample of a measurement may stand for less.
  std::optional<double> interval{};
};

}  // namespace millwear
