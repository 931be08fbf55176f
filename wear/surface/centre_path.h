#pragma once
#include <Eigen/Core>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// The balls that load a liner.
struct RollingBalls {
  double
      smallest;  ///< radius of those that reach farthest into a foot [m]; 0: all reach everywhere
  double mean;   ///< radius, weighted with the load [m]; 0: points, which turn about no edge
};

/// A load of balls that roll over the liner: rate = path * per_path + corrosion.
struct Rolling {
  Eigen::VectorXd path;      ///< by bins, wear/surface/centre_path.h
  Eigen::VectorXd per_path;  ///< rate of a flat surface, by bins [m/s]
  RollingBalls balls;
  double corrosion = 0.0;  ///< depth rate, the same everywhere [m/s]
};

/// The way of the mean ball's centre while it rolls over each of `bins` even bins of a liner, over
/// the bin's width [-]: 1 on a flat, 1 + r / R on a crest of radius R, 1 - r / R in a hollow, much
/// where an edge lies in the bin, and 0 in the shadow of the smallest ball
/// (wear/surface/closing.h). Balls come to every piece of their centres' way alike, so it is along
/// this way that a load is smooth: an edge has a load of its own, and what lies between two edges
/// has little.
[[nodiscard]] Eigen::VectorXd centre_path(const LinerProfile& liner, Eigen::Index bins,
                                          const RollingBalls& balls);

}  // namespace millwear::wear
