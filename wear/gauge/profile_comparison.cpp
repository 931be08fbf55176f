#include "wear/gauge/profile_comparison.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/signed_surface.h"
#include "wear/gauge/area_between.h"
#include "wear/record/profile_index.h"

namespace millwear::wear {
namespace {

constexpr int places_along = 2000;
constexpr double reach = 0.05;

void check_same_sector(const LinerSector& a, const LinerSector& b) {
  if (a.rows != b.rows || a.plate_radius != b.plate_radius || a.shell_radius != b.shell_radius)
    throw InputError("two profiles of different mills cannot be compared; take both of one case");
}

double mean_square_distance(const std::vector<Eigen::Vector2d>& places, const ProfileIndex& other) {
  double sum = 0.0;
  for (const auto& place : places) {
    const double distance = other.nearest(place).distance;
    sum += distance * distance;
  }
  return sum / static_cast<double>(places.size());
}

/// The largest distance of a segment's places from the other curve, if it is above `best`. Between
/// two places d apart the distance exceeds the mean of theirs by d/2 at most.
double farthest(const Eigen::Vector2d& from, double at_from, const Eigen::Vector2d& to,
                double at_to, const ProfileIndex& other, double best) {
  best = std::max({best, at_from, at_to});
  if (0.5 * (at_from + at_to + (to - from).norm()) <= best + hausdorff_tolerance) return best;
  const Eigen::Vector2d middle = 0.5 * (from + to);
  const double at_middle = other.nearest(middle).distance;
  best = farthest(from, at_from, middle, at_middle, other, best);
  return farthest(middle, at_middle, to, at_to, other, best);
}

double farthest_place(const LinerProfile& profile, const ProfileIndex& other) {
  const auto& nodes = profile.nodes;
  std::vector<double> at_node;
  for (const auto& node : nodes) at_node.push_back(other.nearest(node).distance);
  double best = *std::max_element(at_node.begin(), at_node.end());
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    best = farthest(nodes[i], at_node[i], nodes[i + 1], at_node[i + 1], other, best);
  return best;
}

}  // namespace

ProfileDifference compare(const LinerProfile& a, const LinerProfile& b) {
  check_same_sector(a.sector, b.sector);
  if (a.nodes == b.nodes) return {};
  const ProfileIndex to_a(a, reach);
  const ProfileIndex to_b(b, reach);
  const double mean_square = 0.5 * (mean_square_distance(even_places(a, places_along), to_b) +
                                    mean_square_distance(even_places(b, places_along), to_a));
  return {lifter_height(a) - lifter_height(b),
          leading_face_angle(a) - leading_face_angle(b),
          plate_thickness(a) - plate_thickness(b),
          steel_area(a) - steel_area(b),
          area_between(a, b),
          std::sqrt(mean_square),
          std::max(farthest_place(a, to_b), farthest_place(b, to_a))};
}

double highest_above(const LinerProfile& a, const LinerProfile& b) {
  check_same_sector(a.sector, b.sector);
  const SignedSurface surface(b, reach);
  double highest = 0.0;
  for (const auto& place : even_places(a, places_along))
    highest = std::max(highest, surface.place(place).height);
  for (const auto& node : a.nodes) highest = std::max(highest, surface.place(node).height);
  return highest;
}

}  // namespace millwear::wear
