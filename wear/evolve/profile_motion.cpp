#include "wear/evolve/profile_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/steel_cut.h"
#include "wear/evolve/surface_thinning.h"
#include "wear/numerics/segment_distance.h"

namespace millwear::wear {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double closest_share_of_bin = 0.05;
constexpr double scale_within = 1e-6;
constexpr double grid_share = 0.1;
constexpr double lost_in_grid = 10.0 * clipping_grid;
constexpr double nearly = 1e-2;
constexpr double area_within = 1e-9;
/// Rounding of a section as a share of the circle's sector, of which it is a difference.
constexpr double rounding = 1e-14;
constexpr int most_trials = 30;

/// Where the surface touches itself at the very scale that fits, one near it is taken and matched.
constexpr double past_a_touch[] = {1.0, 1.003, 0.997, 1.01, 0.99, 1.03, 0.97};

Points positions(const std::vector<LossNode>& nodes) {
  Points points;
  for (const LossNode& node : nodes) points.push_back(node.position);
  return points;
}

/// The surface with the nodes of the loss that lie on it, so that rounding leaves no sliver between
/// the two.
Points with_loss_nodes(const Points& surface, const std::vector<LossNode>& loss) {
  Points points{surface.front()};
  std::vector<std::pair<double, Eigen::Vector2d>> between;
  for (std::size_t i = 0; i + 1 < surface.size(); ++i) {
    const Eigen::Vector2d along = surface[i + 1] - surface[i];
    between.clear();
    for (const LossNode& node : loss) {
      const double way = (node.position - surface[i]).dot(along) / along.norm();
      const bool is_beside = way > clipping_grid && way < along.norm() - clipping_grid;
      if (is_beside &&
          distance_to_segment(node.position, surface[i], surface[i + 1]) < clipping_grid)
        between.emplace_back(way, node.position);
    }
    std::sort(between.begin(), between.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [way, position] : between)
      if (points.back() != position) points.push_back(position);
    points.push_back(surface[i + 1]);
  }
  return points;
}

/// An arc far below the shell, over the same sectors as the three pitches of the surface.
Points bottom_under(const LinerProfile& profile) {
  const LinerSector& sector = profile.sector;
  double innermost = sector.shell_radius;
  for (const auto& node : profile.nodes) {
    innermost = std::min(innermost, radius_of(sector, node));
  }
  constexpr int facets = 12;
  const double first = angle_of(sector, profile.nodes.front()) - sector.pitch();
  const double step = 3.0 * sector.pitch() / facets;
  const double radius =
      (sector.shell_radius + 2.0 * (sector.shell_radius - innermost)) / std::cos(0.5 * step);
  Points bottom;
  for (int i = 0; i <= facets; ++i) bottom.push_back(point_at(sector, radius, first + i * step));
  return bottom;
}

struct Crossing {
  std::size_t next;  ///< first node after the ray
  double radius;     ///< [m]
};

/// Where the surface passes the ray from the mill's axis at `angle`, along the rotation.
std::vector<Crossing> across(const LinerSector& sector, const Points& surface, double angle) {
  const auto side = [&](const Eigen::Vector2d& point) {
    return std::sin(angle_of(sector, point) - angle) * radius_of(sector, point);
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 1; i < surface.size(); ++i) {
    const double before = side(surface[i - 1]);
    const double after = side(surface[i]);
    if (before < 0.0 && after >= 0.0) {
      const double share = before / (before - after);
      const Eigen::Vector2d place = surface[i - 1] + share * (surface[i] - surface[i - 1]);
      crossings.push_back({i, radius_of(sector, place)});
    }
  }
  if (crossings.empty())
    throw ResultRejected("the worn profile does not reach from one sector edge to the other");
  return crossings;
}

/// The pitch in the middle of three; ends that are nodes of the old profile stay exactly.
LinerProfile middle_pitch(const LinerProfile& old, const Points& surface) {
  const LinerSector& sector = old.sector;
  const auto first = std::find(surface.begin(), surface.end(), old.nodes.front());
  const auto last = std::find(first, surface.end(), old.nodes.back());
  if (last != surface.end()) return {sector, {first, last + 1}};

  const double angle = angle_of(sector, old.nodes.front());
  const Crossing left = across(sector, surface, angle).front();
  const auto images = across(sector, surface, angle + sector.pitch());
  const Crossing right = *std::min_element(images.begin(), images.end(), [&](auto a, auto b) {
    return std::abs(a.radius - left.radius) < std::abs(b.radius - left.radius);
  });
  constexpr double apart = 2.0 * clipping_grid;
  const Eigen::Vector2d start = point_at(sector, left.radius, angle);
  const Eigen::Vector2d end = point_at(sector, left.radius, angle + sector.pitch());
  LinerProfile profile{sector, {start}};
  for (std::size_t i = left.next; i < right.next; ++i) {
    if ((surface[i] - start).norm() > apart && (surface[i] - end).norm() > apart) {
      profile.nodes.push_back(surface[i]);
    }
  }
  profile.nodes.push_back(end);
  return profile;
}

double distance_to(const Points& line, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    least = std::min(least, distance_to_segment(point, line[i], line[i + 1]));
  }
  return least;
}

bool same_place(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a == b; }

std::vector<SurfaceNode> surface_nodes(const LinerProfile& old, const Points& old_surface,
                                       const LinerProfile& worn) {
  std::vector<SurfaceNode> nodes;
  for (const auto& position : worn.nodes) {
    const bool fixed = std::any_of(old.nodes.begin(), old.nodes.end(),
                                   [&](const auto& node) { return same_place(node, position); });
    nodes.push_back({position, fixed ? 0.0 : distance_to(old_surface, position), fixed});
  }
  return nodes;
}

/// Every node that is not fixed, moved along its inward normal by `share` of its depth.
LinerProfile deepened(const LinerSector& sector, const std::vector<SurfaceNode>& surface,
                      double share) {
  LinerProfile profile{sector, {}};
  for (const SurfaceNode& node : surface) profile.nodes.push_back(node.position);
  for (std::size_t i = 1; i + 1 < surface.size(); ++i) {
    const Eigen::Vector2d along = (surface[i + 1].position - surface[i].position).normalized() +
                                  (surface[i].position - surface[i - 1].position).normalized();
    if (surface[i].fixed || !(along.norm() > 0.0)) continue;
    const Eigen::Vector2d inward = Eigen::Vector2d(along.y(), -along.x()).normalized();
    profile.nodes[i] += share * surface[i].depth * inward;
  }
  if (!surface.front().fixed) {
    const double radius =
        radius_of(sector, surface.front().position) + share * surface.front().depth;
    const double angle = angle_of(sector, surface.front().position);
    profile.nodes.front() = point_at(sector, radius, angle);
    profile.nodes.back() = point_at(sector, radius, angle + sector.pitch());
  }
  return profile;
}

/// The surface deepened a little until exactly `target_area` went; nothing if that takes more than
/// a little, or makes the profile cross itself.
std::optional<LinerProfile> matched(const LinerProfile& old,
                                    const std::vector<SurfaceNode>& surface, double target_area) {
  constexpr double most_deepening = 0.2;
  const double old_area = steel_area(old);
  const double within =
      std::max(area_within * target_area,
               rounding * 0.5 * old.sector.pitch() * std::pow(old.sector.shell_radius, 2));
  const auto excess = [&](double share) {
    return old_area - steel_area(deepened(old.sector, surface, share)) - target_area;
  };
  double share = 0.0;
  double error = excess(share);
  double next_share = 1e-3;
  for (int trial = 0; trial < most_trials; ++trial) {
    const double next_error = excess(next_share);
    if (next_error == error) break;
    const double slope = (next_error - error) / (next_share - share);
    share = next_share;
    error = next_error;
    if (std::abs(error) <= 1e-3 * within) break;
    next_share = share - error / slope;
  }
  if (!(std::abs(error) <= within) || std::abs(share) > most_deepening) {
    return std::nullopt;
  }
  LinerProfile profile = deepened(old.sector, surface, share);
  if (first_crossing(profile) != std::pair(-1, -1)) return std::nullopt;
  return profile;
}

/// The same, of the surface without the nodes it can do without, where that will do.
std::optional<LinerProfile> matched_with_few_nodes(const LinerProfile& old,
                                                   const std::vector<SurfaceNode>& surface,
                                                   double target_area, double resolution) {
  const auto few = thinned(surface, closest_share_of_bin * resolution);
  auto profile = matched(old, few, target_area);
  return profile ? profile : matched(old, surface, target_area);
}

/// The surface after a loss that the grid cannot resolve: so shallow that no piece meets another.
std::vector<SurfaceNode> moved_along_normals(const LinerSector& sector,
                                             const std::vector<LossNode>& loss) {
  std::vector<SurfaceNode> nodes;
  for (const LossNode& node : loss) {
    const bool is_edge = !nodes.empty() && nodes.back().position == node.position;
    if (!is_edge) nodes.push_back({node.position, node.depth, node.depth == 0.0});
  }
  const LinerProfile moved = deepened(sector, nodes, 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].position = moved.nodes[i];
  return nodes;
}

double deepest(const std::vector<LossNode>& nodes) {
  return std::max_element(nodes.begin(), nodes.end(),
                          [](const auto& a, const auto& b) { return a.depth < b.depth; })
      ->depth;
}

/// Area of the pieces whose centres lie on the pitch in the middle of three [m2].
double area_on_middle_pitch(const LinerProfile& old, const std::vector<Polygon>& pieces) {
  const double first = angle_of(old.sector, old.nodes.front());
  double sum = 0.0;
  for (const Polygon& piece : pieces) {
    const Eigen::Vector2d& origin = piece.front();
    double area = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
      const Eigen::Vector2d a = piece[i] - origin;
      const Eigen::Vector2d b = piece[i + 1] - origin;
      const double triangle = 0.5 * (a.x() * b.y() - a.y() * b.x());
      area += triangle;
      moment += triangle / 3.0 * (a + b);
    }
    const double angle = angle_of(old.sector, origin + moment / area) - first;
    if (angle >= 0.0 && angle < old.sector.pitch()) sum += std::abs(area);
  }
  return sum;
}

struct Trial {
  LinerProfile profile;
  double worn_area;
  double dropped_area;
};

/// A piece fell off and took the account's rest with it: what stands may be bounded by old faces
/// and the cut through them alone, with no surface left that could go deeper.
bool is_valid_remainder(const Trial& trial) {
  return trial.dropped_area > 0.0 && first_crossing(trial.profile) == std::pair(-1, -1);
}

struct ScaledTrial {
  Trial trial;
  double scale;
};

/// The scale of the depths that wears the wanted area off, `within` [m2]; where a piece that comes
/// loose makes the area jump over it, nearly.
template <typename Take>
ScaledTrial find_scale(const Take& take, double first_scale, double target_area, double within) {
  double low = 0.0;
  double low_error = -target_area;
  double high = std::numeric_limits<double>::infinity();
  double high_error = 0.0;
  double scale = first_scale;
  for (int trial = 0; trial < most_trials; ++trial) {
    Trial found = take(scale);
    const double error = found.worn_area - target_area;
    const bool is_last = trial + 1 == most_trials && std::abs(error) <= nearly * target_area;
    if (std::abs(error) <= within || is_last) return {std::move(found), scale};
    (error < 0.0 ? low : high) = scale;
    (error < 0.0 ? low_error : high_error) = error;
    const bool bracketed = std::isfinite(high);
    const double growth = trial < 2 ? 1.0 : 1.5;
    const double next = scale * std::max(growth, target_area / found.worn_area);
    const double chord = low - low_error * (high - low) / (high_error - low_error);
    const double inside = trial % 4 == 3 ? 0.5 * (low + high) : chord;
    scale = bracketed && (trial > 1 || !(next > low && next < high)) ? inside : next;
    if (!std::isfinite(scale)) break;
  }
  throw ResultRejected(fmt::format(
      "no depth of loss removes {:g} m2 of the profile; shorten the step", target_area));
}

}  // namespace

MovedProfile move_profile(const LinerProfile& profile, const std::vector<LossNode>& loss,
                          double target_area, double resolution) {
  const LinerSector& sector = profile.sector;
  expect(sector.rows >= 4, "a profile is moved in a mill of at least 4 rows");
  expect(target_area >= 0.0, "the area to remove is not negative");
  if (target_area == 0.0) return {profile, 0.0, 0.0, 0.0};
  if (target_area >= steel_area(profile)) {
    throw ResultRejected(
        fmt::format("the load takes {:g} m2 of steel off a section of {:g} m2; shorten the step",
                    target_area, steel_area(profile)));
  }
  const double unscaled = loss_area(loss);
  if (!(unscaled > 0.0)) throw ResultRejected("no load wears the profile, yet steel is to go");

  const double first_scale = target_area / unscaled;
  if (first_scale * deepest(loss) < lost_in_grid) {
    const auto surface = moved_along_normals(sector, scaled(loss, first_scale));
    const auto result = matched_with_few_nodes(profile, surface, target_area, resolution);
    if (result) {
      return {*result, steel_area(profile) - steel_area(*result), first_scale, 0.0};
    }
  }

  const auto nodes = over_three_pitches(sector, loss);
  std::vector<LossNode> corners;
  for (const auto& node : profile.nodes) corners.push_back({node, 0.0});
  const Points old_surface = positions(over_three_pitches(sector, corners));
  const Points surface = with_loss_nodes(old_surface, nodes);
  const Points bottom = bottom_under(profile);
  const auto take = [&](double scale) {
    const SteelCut left = cut(surface, bottom, swept_region(scaled(nodes, scale)));
    Trial trial{middle_pitch(profile, left.surface), 0.0,
                area_on_middle_pitch(profile, left.dropped)};
    trial.worn_area = steel_area(profile) - steel_area(trial.profile) - trial.dropped_area;
    return trial;
  };
  const double grid_area = grid_share * clipping_grid * arc_lengths(profile).back();
  const ScaledTrial found =
      find_scale(take, first_scale, target_area, std::max(scale_within * target_area, grid_area));
  for (const double nudge : past_a_touch) {
    const Trial trial = nudge == 1.0 ? found.trial : take(nudge * found.scale);
    const double removed_area = target_area + trial.dropped_area;
    const auto worn = surface_nodes(profile, old_surface, trial.profile);
    auto result = matched_with_few_nodes(profile, worn, removed_area, resolution);
    if (!result && is_valid_remainder(trial)) result = trial.profile;
    if (!result) continue;
    const double removed = steel_area(profile) - steel_area(*result);
    const double dropped = trial.dropped_area > 0.0 ? removed - target_area : 0.0;
    return {*result, removed, found.scale, dropped};
  }
  throw ResultRejected(
      fmt::format("taking {:g} m2 off the profile leaves one that crosses itself; shorten the step",
                  target_area));
}

}  // namespace millwear::wear
