#pragma once
#include <vector>

namespace millwear {

struct Case;

/// What resists the slip of a class's particles on the liner, in the Hertz and Mindlin contact that
/// the DEM has.
struct LinerFriction {
  double coefficient;       ///< sliding friction mu [-]
  double damping_constant;  ///< of `tangential_damping` [N s m^-5/4]
};

/// Of every particle class.
[[nodiscard]] std::vector<LinerFriction> liner_friction(const Case& mill);

/// The damper beside the tangential spring of a contact that friction holds [N s/m]:
///     gamma_t = 2 sqrt(5/6) |beta| sqrt(k_t m),   k_t = 8 G* sqrt(R delta),
///     beta = ln e / sqrt(ln^2 e + pi^2),   1 / G* = sum of (2 - nu) / G over both materials,
/// R the sphere's radius, delta the `overlap` [m], m the sphere's mass, e restitution; the wall
/// weighs infinitely much. No overlap, no damper. Source: LIGGGHTS, `gran model hertz tangential
/// history`; Tsuji, Tanaka and Ishida (1992), Powder Technology 71, 239, for the form.
[[nodiscard]] double tangential_damping(const LinerFriction& friction, double overlap);

}  // namespace millwear
