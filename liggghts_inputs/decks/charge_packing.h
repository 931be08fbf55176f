#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear::liggghts {

/// A particle before the first step, at rest.
struct PlacedParticle {
  Eigen::Vector3d centre;      ///< [m], mill frame, y in [0, slice length)
  std::size_t particle_class;  ///< index into Charge::classes
};

/// Places every particle of the charge at random inside the liner (at mill angle 0), largest
/// classes first, none touching another (y is periodic) or the liner, as low as a loose packing
/// allows, under a surface that leans as that of a charge in motion. The same seed gives the same
/// packing on every machine and for any number of ranks, and the count is exactly what was asked:
/// LIGGGHTS's own insertion can fall short with only a warning. Throws InputError where the charge
/// is too much to be placed apart (above roughly 38 % solid).
[[nodiscard]] std::vector<PlacedParticle> pack_charge(const Case& mill);

/// The packing as a LIGGGHTS data file, in a box that encloses the shell and goes on beyond its
/// rising side as far as puts the box's middle where the charge in motion has its own: cut there,
/// it gives two ranks half of the particles each.
[[nodiscard]] std::string charge_data_file(const Case& mill,
                                           const std::vector<PlacedParticle>& charge);

}  // namespace millwear::liggghts
