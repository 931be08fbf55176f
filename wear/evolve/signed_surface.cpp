#include "wear/evolve/signed_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/contract.h"

namespace millwear::wear {
namespace {

constexpr double same_arc = 1e-12;
constexpr double on_surface = 1e-12;

LinerProfile without_repeated_nodes(LinerProfile profile) {
  auto& nodes = profile.nodes;
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  expect(nodes.size() >= 2, "a liner profile has at least two different nodes");
  return profile;
}

/// Out of the steel, which lies to the right of the way along the profile.
Eigen::Vector2d normal_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = (to - from).normalized();
  return {-along.y(), along.x()};
}

}  // namespace

SignedSurface::SignedSurface(const LinerProfile& profile, double reach)
    : profile_(without_repeated_nodes(profile)),
      arc_(arc_lengths(profile_)),
      index_(profile_, reach) {}

Eigen::Vector2d SignedSurface::outward_at(std::size_t segment, double arc_length) const {
  const auto& nodes = profile_.nodes;
  const auto& sector = profile_.sector;
  const std::size_t last = nodes.size() - 2;
  const Eigen::Vector2d here = normal_of(nodes[segment], nodes[segment + 1]);
  const auto meet = [&](const Eigen::Vector2d& other) -> Eigen::Vector2d {
    return (here + other).normalized();
  };
  if (arc_length - arc_[segment] < same_arc) {
    if (segment > 0) return meet(normal_of(nodes[segment - 1], nodes[segment]));
    return meet(normal_of(shifted_by_pitches(sector, nodes[last], -1),
                          shifted_by_pitches(sector, nodes[last + 1], -1)));
  }
  if (arc_[segment + 1] - arc_length < same_arc) {
    if (segment < last) return meet(normal_of(nodes[segment + 1], nodes[segment + 2]));
    return meet(normal_of(shifted_by_pitches(sector, nodes[0], 1),
                          shifted_by_pitches(sector, nodes[1], 1)));
  }
  return here;
}

SurfacePlace SignedSurface::place(const Eigen::Vector2d& point) const {
  const auto& sector = profile_.sector;
  const int pitches = static_cast<int>(std::lround(angle_of(sector, point) / sector.pitch()));
  const Eigen::Vector2d here = shifted_by_pitches(sector, point, -pitches);
  const ProfilePlace nearest = index_.nearest(here);
  const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, nearest.arc_length);
  const auto segment = static_cast<std::size_t>(after - arc_.begin()) - 1;
  const double share = (nearest.arc_length - arc_[segment]) / (arc_[segment + 1] - arc_[segment]);
  const Eigen::Vector2d on_pitch =
      profile_.nodes[segment] + share * (profile_.nodes[segment + 1] - profile_.nodes[segment]);

  int image = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const int k : {0, -1, 1}) {
    const double distance = (shifted_by_pitches(sector, on_pitch, k) - here).norm();
    if (distance < least) {
      least = distance;
      image = k;
    }
  }
  const Eigen::Vector2d position = shifted_by_pitches(sector, on_pitch, image + pitches);
  const Eigen::Vector2d axis(0.0, sector.plate_radius);
  const Eigen::Vector2d side =
      shifted_by_pitches(sector, axis + outward_at(segment, nearest.arc_length), image + pitches);
  const Eigen::Vector2d outward = side - axis;
  const Eigen::Vector2d offset = point - position;
  const double sign = offset.dot(outward) < 0.0 ? -1.0 : 1.0;
  return {sign * nearest.distance, position,
          nearest.distance > on_surface ? Eigen::Vector2d(sign * offset.normalized()) : outward,
          nearest.arc_length};
}

std::vector<Eigen::Vector2d> even_places(const LinerProfile& profile, int count) {
  const auto arc = arc_lengths(profile);
  std::vector<Eigen::Vector2d> places;
  std::size_t segment = 0;
  for (int i = 0; i < count; ++i) {
    const double s = (i + 0.5) * arc.back() / count;
    while (segment + 2 < arc.size() && arc[segment + 1] < s) ++segment;
    const double length = arc[segment + 1] - arc[segment];
    const double share = length > 0.0 ? (s - arc[segment]) / length : 0.0;
    places.emplace_back(profile.nodes[segment] +
                        share * (profile.nodes[segment + 1] - profile.nodes[segment]));
  }
  return places;
}

}  // namespace millwear::wear
