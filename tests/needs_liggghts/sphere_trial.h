#pragma once
#include <Eigen/Core>
#include <string>

#include "tests/needs_liggghts/trial_run.h"

namespace millwear::trial {

/// One sphere at the start of a trial.
struct Launch {
  Eigen::Vector3d centre;    ///< [m]
  Eigen::Vector3d velocity;  ///< [m/s]
  Eigen::Vector3d spin;      ///< [rad/s]
};

inline constexpr double sphere_radius = 0.015;
inline constexpr double sphere_mass = 7800.0 * 4.0 / 3.0 * 3.141592653589793 * sphere_radius *
                                      sphere_radius * sphere_radius;  ///< [kg]
inline constexpr double gravity = 9.81;
inline constexpr double floor_level = -0.2;  ///< z of the square mill's lowest plate [m]

/// A mill of four flat plates, 0.4 m square, that stands still (it turns at 1e-12 rad/s), and one
/// steel sphere of 30 mm in it.
[[nodiscard]] Case square_mill(double restitution = 0.3);

/// A round mill of 0.4 m without lifters, cut into 144 facets, that turns at 3 rad/s. Friction is
/// 0.05, so that the facets' slopes of 1.25 degrees make it press 0.1 % at most, and restitution
/// 0.9, because damping that pulls takes from the wall's impulse and not from its sliding work.
[[nodiscard]] Case round_mill();

/// How deep the sphere sinks into the plate under its own weight [m]:
///     delta = (3 m g / (4 E* sqrt(R)))^(2/3),   E* = E / (2 (1 - nu^2)),  E = 2 G (1 + nu).
[[nodiscard]] double resting_overlap(const Case& mill);

/// The sphere at rest on the plate over (x, y) of `place`, without spin, moving with `velocity`
/// [m/s].
[[nodiscard]] Launch resting(const Case& mill, const Eigen::Vector3d& place,
                             const Eigen::Vector3d& velocity);

/// Deck lines that hold the sphere's spin at zero and its speed along the plate at what it is;
/// up and down it stays free.
inline constexpr const char* drag_without_rolling =
    "unfix integrate\nfix integrate all nve\nfix drag all setforce 0.0 0.0 NULL\n";

/// Runs the measuring deck of the program, with the sphere as its charge in the place of a restart
/// file, and `lines` after the contact model.
[[nodiscard]] Dumps run_sphere(const Case& mill, const liggghts::StretchSteps& steps,
                               const Launch& launch, const std::string& lines = {});

/// The same with the recorder.
[[nodiscard]] Recording record_sphere(const Case& mill, const liggghts::StretchSteps& steps,
                                      const Launch& launch, const std::string& lines = {},
                                      int ranks = 1);

}  // namespace millwear::trial
