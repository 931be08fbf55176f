#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear::liggghts {

/// A particle before the first step.
struct PlacedParticle {
  Eigen::Vector3d centre;                              ///< [m], mill frame, y in [0, slice length)
  std::size_t particle_class;                          ///< index into Charge::classes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< angular velocity [rad/s]
};

/// Height z [m] under which a circle about the origin holds `area` [m2].
[[nodiscard]] double level_for_area(double radius, double area);

/// The charge as a LIGGGHTS data file, in a box that encloses the shell and goes on beyond its
/// rising side as far as puts the box's middle where the charge in motion has its own: cut there,
/// it gives two ranks half of the particles each.
[[nodiscard]] std::string charge_data_file(const Case& mill,
                                           const std::vector<PlacedParticle>& charge);

}  // namespace millwear::liggghts
