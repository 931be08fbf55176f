#include "wear/gauge/profile_alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_ends.h"
#include "wear/evolve/signed_surface.h"

namespace millwear::wear {
namespace {

constexpr int places_along = 400;

Curve moved(const Curve& curve, const RigidMotion& motion) {
  Curve result;
  for (const auto& node : curve) result.push_back(motion(node));
  return result;
}

double mean_square_height(const SignedSurface& surface, const Curve& places) {
  double sum = 0.0;
  for (const auto& place : places) {
    const double height = surface.place(place).height;
    sum += height * height;
  }
  return sum / static_cast<double>(places.size());
}

/// The turn and shift that put the segment from `first` to `last` on the chord between two places
/// of the circle that lie symmetrically to the lifter's centre.
RigidMotion onto_chord(const Eigen::Vector2d& first, const Eigen::Vector2d& last,
                       const Eigen::Vector2d& middle) {
  const Eigen::Vector2d along = last - first;
  const RigidMotion turn{-std::atan2(along.y(), along.x()), Eigen::Vector2d::Zero()};
  return {turn.angle, middle - turn(0.5 * (first + last))};
}

/// Joins a curve on the circle of `radius` to the sector's edges by the circle's arc.
Curve joined_to_edges(const LinerSector& sector, Curve nodes, double radius) {
  const double edge = 0.5 * sector.pitch();
  const double foot = angle_of(sector, nodes.back());
  Curve result{point_at(sector, radius, -edge)};
  const auto add = [&](const Curve& more) {
    result.insert(result.end(), more.begin(), more.end());
  };
  add(nodes_between(sector, radius, -edge, -foot));
  add(nodes);
  add(nodes_between(sector, radius, foot, edge));
  result.push_back(point_at(sector, radius, edge));
  return result;
}

}  // namespace

Eigen::Vector2d RigidMotion::operator()(const Eigen::Vector2d& point) const {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * point.x() - s * point.y() + shift.x(), s * point.x() + c * point.y() + shift.y()};
}

Curve mirror_image(const Curve& curve) {
  Curve result = curve;
  for (auto& node : result) node.x() = -node.x();
  return result;
}

AlignedCurve kept_in_place(const LinerSector& sector, const Curve& curve) {
  AlignedCurve aligned{curve, {0.0, Eigen::Vector2d::Zero()}, false};
  if (curve.size() > 1 && angle_of(sector, curve.front()) > angle_of(sector, curve.back())) {
    std::reverse(aligned.nodes.begin(), aligned.nodes.end());
    aligned.reversed = true;
  }
  return aligned;
}

AlignedCurve aligned_by_ends(const LinerProfile& reference, const Curve& curve, double end_radius,
                             double error) {
  const auto& sector = reference.sector;
  if (curve.size() < 3) throw InputError("a curve of fewer than three nodes has no shape to align");
  const double chord = (curve.back() - curve.front()).norm();
  const double edges = 2.0 * end_radius * std::sin(0.5 * sector.pitch());
  const double slack = 3.0 * std::sqrt(2.0) * error + 2.0 * profile_end_tolerance;
  if (chord > edges + slack || chord <= slack)
    throw InputError(fmt::format(
        "the curve's ends are {:.1f} mm apart, the edges of a pitch {:.1f} mm where the plate's "
        "radius is {:.1f} mm; begin and end it at the same place of two neighbouring pitches or on "
        "the plate, give the plate's thickness there, or fit it on the unworn parts",
        1e3 * chord, 1e3 * edges, 1e3 * end_radius));
  const bool whole_pitch = chord >= edges - slack;
  const double off_axis = std::sqrt(end_radius * end_radius - 0.25 * chord * chord);
  const Eigen::Vector2d middle(0.0, sector.plate_radius - off_axis);

  const SignedSurface surface(reference, 0.5 * edges);
  const Curve places = even_places({sector, curve}, places_along);
  const RigidMotion forward = onto_chord(curve.front(), curve.back(), middle);
  const RigidMotion backward = onto_chord(curve.back(), curve.front(), middle);
  const bool reversed = mean_square_height(surface, moved(places, backward)) <
                        mean_square_height(surface, moved(places, forward));
  AlignedCurve aligned{{}, reversed ? backward : forward, reversed};
  aligned.nodes = moved(curve, aligned.motion);
  if (reversed) std::reverse(aligned.nodes.begin(), aligned.nodes.end());
  if (!whole_pitch || chord < edges)
    aligned.nodes = joined_to_edges(sector, std::move(aligned.nodes), end_radius);
  return aligned;
}

}  // namespace millwear::wear
