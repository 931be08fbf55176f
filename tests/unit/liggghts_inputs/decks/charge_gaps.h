#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "liggghts_inputs/decks/charge_data.h"
#include "mill/liner/mill_frame.h"

namespace millwear::liggghts {

inline double radius_of(const Case& mill, const PlacedParticle& particle) {
  return 0.5 * mill.charge.classes[particle.particle_class].diameter;
}

/// Least gap between any two particles [m], negative where they overlap. Compares all with all.
inline double least_gap(const Case& mill, const std::vector<PlacedParticle>& charge) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < charge.size(); ++i)
    for (std::size_t j = i + 1; j < charge.size(); ++j) {
      Eigen::Vector3d apart = charge[i].centre - charge[j].centre;
      apart.y() = std::abs(apart.y());
      apart.y() = std::min(apart.y(), mill.slice_length - apart.y());
      least =
          std::min(least, apart.norm() - radius_of(mill, charge[i]) - radius_of(mill, charge[j]));
    }
  return least;
}

/// The liner's whole outline (x, z) around the mill, at mill angle 0.
inline std::vector<Eigen::Vector2d> outline(const LinerProfile& liner) {
  std::vector<Eigen::Vector2d> ring;
  for (int row = 0; row < liner.sector.rows; ++row)
    for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i)
      ring.push_back(to_mill(liner.sector, liner.nodes[i], row, 0.0));
  return ring;
}

/// How far a place is from the outline [m], negative outside of it, in the steel.
inline double clearance(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& place) {
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i];
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - a;
    const double t = std::clamp((place - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * along - place).norm());
    const double share = (place.y() - a.y()) / along.y();
    if (share >= 0.0 && share < 1.0 && place.x() < a.x() + share * along.x()) inside = !inside;
  }
  return inside ? nearest : -nearest;
}

inline double least_clearance(const Case& mill, const std::vector<PlacedParticle>& charge) {
  const auto ring = outline(mill.liner);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& particle : charge)
    least = std::min(least, clearance(ring, {particle.centre.x(), particle.centre.z()}) -
                                radius_of(mill, particle));
  return least;
}

}  // namespace millwear::liggghts
