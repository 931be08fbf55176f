#include "wear/evolve/surface_thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wear/numerics/segment_distance.h"

namespace millwear::wear {
namespace {

constexpr double straight_within = 1e-6;
constexpr double no_depth = 1.5e-9;

/// The chord passes above the point, on the side of the charge.
bool chord_adds_steel(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const Eigen::Vector2d offset = point - from;
  return along.x() * offset.y() - along.y() * offset.x() < 0.0;
}

double most_lift(const SurfaceNode& node) {
  return node.depth < no_depth ? no_depth : 0.5 * node.depth;
}

void keep_the_bends(const std::vector<SurfaceNode>& surface, std::size_t from, std::size_t to,
                    std::vector<bool>& kept) {
  double worst = 1.0;
  std::size_t bend = from;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double excess =
        distance_to_segment(surface[i].position, surface[from].position, surface[to].position) /
        std::min(straight_within, most_lift(surface[i]));
    if (excess > worst) {
      worst = excess;
      bend = i;
    }
  }
  if (bend == from) return;
  kept[bend] = true;
  keep_the_bends(surface, from, bend, kept);
  keep_the_bends(surface, bend, to, kept);
}

/// Indices of the nodes without which the surface would bend otherwise.
std::vector<std::size_t> bends(const std::vector<SurfaceNode>& surface) {
  std::vector<bool> kept(surface.size(), false);
  std::size_t anchor = 0;
  kept.front() = kept.back() = true;
  for (std::size_t i = 1; i < surface.size(); ++i) {
    if (!surface[i].fixed && i + 1 < surface.size()) continue;
    kept[i] = true;
    keep_the_bends(surface, anchor, i, kept);
    anchor = i;
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (kept[i]) result.push_back(i);
  }
  return result;
}

/// How far the surface moves if kept[i] goes too, or infinity where it must stay: none of the nodes
/// that the new chord replaces may be lifted too far.
double cost_of_dropping(const std::vector<SurfaceNode>& surface,
                        const std::vector<std::size_t>& kept, std::size_t i) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (i == 0 || i + 1 == kept.size() || surface[kept[i]].fixed) return never;
  const auto& from = surface[kept[i - 1]].position;
  const auto& to = surface[kept[i + 1]].position;
  double cost = 0.0;
  for (std::size_t k = kept[i - 1] + 1; k < kept[i + 1]; ++k) {
    const SurfaceNode& node = surface[k];
    const double moved = distance_to_segment(node.position, from, to);
    const bool may_not_move = node.depth < no_depth || chord_adds_steel(node.position, from, to);
    if (may_not_move && moved > most_lift(node)) return never;
    cost = std::max(cost, moved);
  }
  return cost;
}

}  // namespace

std::vector<SurfaceNode> thinned(const std::vector<SurfaceNode>& surface, double closest) {
  std::vector<std::size_t> kept = bends(surface);
  for (std::size_t i = 0; i + 1 < kept.size();) {
    const double apart = (surface[kept[i + 1]].position - surface[kept[i]].position).norm();
    const double here = cost_of_dropping(surface, kept, i);
    const double next = cost_of_dropping(surface, kept, i + 1);
    if (!(apart < closest) || std::isinf(std::min(here, next))) {
      ++i;
      continue;
    }
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(here < next ? i : i + 1));
    if (here < next && i > 0) --i;
  }
  std::vector<SurfaceNode> result;
  for (const std::size_t i : kept) result.push_back(surface[i]);
  return result;
}

}  // namespace millwear::wear
