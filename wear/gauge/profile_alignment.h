#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

using Curve = std::vector<Eigen::Vector2d>;

/// A rotation about the origin, then a shift:  p -> R(angle) p + shift.
struct RigidMotion {
  double angle;           ///< [rad]
  Eigen::Vector2d shift;  ///< [m]

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& point) const;
};

/// A curve in the frame of the master lifter, from its trailing side to its leading one.
struct AlignedCurve {
  Curve nodes;         ///< (xi, eta) [m]
  RigidMotion motion;  ///< from the frame it came in
  bool reversed;       ///< its nodes came in the opposite order
};

/// The curve as seen from the other end of the mill: x changes sign.
[[nodiscard]] Curve mirror_image(const Curve& curve);

/// A curve that lies in the master frame already: only its order may change.
[[nodiscard]] AlignedCurve kept_in_place(const LinerSector& sector, const Curve& curve);

/// Puts the two ends of the curve symmetrically on the circle of `end_radius` [m] about the mill's
/// axis: at the sector's edges where they are as far apart as these, within three standard errors
/// of their distance and a millimetre; else, where they are closer, on the plate before and behind
/// the lifter, whose arc is added up to the edges. The order of the nodes and which way is up are
/// those in which the curve lies nearer to `reference`. The place of the plate is not in the curve:
/// `end_radius` says it. `error` is the standard error of a length [m]. Throws InputError for fewer
/// than three nodes, and for ends that coincide or are farther apart than the edges.
[[nodiscard]] AlignedCurve aligned_by_ends(const LinerProfile& reference, const Curve& curve,
                                           double end_radius, double error);

}  // namespace millwear::wear
