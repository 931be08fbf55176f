#pragma once
#include "wear/record/profile_index.h"

namespace millwear::wear {

/// How a point lies to a liner's surface.
struct SurfacePlace {
  double height;             ///< distance from the surface [m]: > 0 in the open, < 0 in the steel
  Eigen::Vector2d position;  ///< the nearest place of the surface, (xi, eta) [m]
  Eigen::Vector2d outward;   ///< unit vector along which `height` grows fastest
  double arc_length;         ///< of that place from the profile's first node [m]
};

/// A liner's surface and its images on the two neighbouring pitches, with its two sides.
/// At a corner the side is told by the mean of the two normals, which is exact in the plane.
class SignedSurface {
 public:
  /// `reach` [m], > 0: points within it are found fast. The profile has at least two
  /// different nodes (std::logic_error).
  SignedSurface(const LinerProfile& profile, double reach);

  [[nodiscard]] SurfacePlace place(const Eigen::Vector2d& point) const;

  [[nodiscard]] double length() const { return index_.length(); }

 private:
  [[nodiscard]] Eigen::Vector2d outward_at(std::size_t segment, double arc_length) const;

  LinerProfile profile_;  ///< without repeated nodes
  std::vector<double> arc_;
  ProfileIndex index_;
};

/// `count` places, the middles of equal parts of the profile's length.
[[nodiscard]] std::vector<Eigen::Vector2d> even_places(const LinerProfile& profile, int count);

}  // namespace millwear::wear
