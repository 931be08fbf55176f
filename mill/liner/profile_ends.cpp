#include "mill/liner/profile_ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear {
namespace {

constexpr double at_edge = 1e-9;    // [m]
constexpr double rounding = 1e-12;  // [m]

/// Cuts what lies beyond the sector's trailing edge, putting a node where the profile passes it.
void cut_at_trailing_edge(const LinerSector& sector, std::vector<Eigen::Vector2d>& nodes) {
  const double edge = -0.5 * sector.pitch();
  const double slack = profile_end_tolerance / sector.plate_radius;
  const auto inside = std::find_if(nodes.begin(), nodes.end(), [&](const Eigen::Vector2d& node) {
    return angle_of(sector, node) >= edge;
  });
  if (inside == nodes.begin() || inside == nodes.end() ||
      angle_of(sector, nodes.front()) >= edge - slack) {
    return;
  }
  const Eigen::Vector2d& out = *(inside - 1);
  const double before = edge - angle_of(sector, out);
  const double share = before / (before + angle_of(sector, *inside) - edge);
  const Eigen::Vector2d passing = out + share * (*inside - out);
  const Eigen::Vector2d cut = point_at(sector, radius_of(sector, passing), edge);
  nodes.erase(nodes.begin(), (*inside - cut).norm() <= same_point ? inside + 1 : inside);
  nodes.insert(nodes.begin(), cut);
}

void mirror(std::vector<Eigen::Vector2d>& nodes) {
  std::reverse(nodes.begin(), nodes.end());
  for (Eigen::Vector2d& node : nodes) {
    node.x() = -node.x();
  }
}

/// Joins the trailing end of a bare lifter to the trailing sector edge along the plate.
void extend_to_trailing_edge(const LinerSector& sector, std::vector<Eigen::Vector2d>& nodes) {
  const double edge = -0.5 * sector.pitch();
  const double foot = angle_of(sector, nodes.front());
  nodes.front() = point_at(sector, sector.plate_radius, foot);
  const auto plate = nodes_between(sector, sector.plate_radius, edge, foot);
  nodes.insert(nodes.begin(), plate.begin(), plate.end());
  nodes.insert(nodes.begin(), point_at(sector, sector.plate_radius, edge));
}

void snap_to_edges(const LinerSector& sector, std::vector<Eigen::Vector2d>& nodes) {
  const double radius = 0.5 * (radius_of(sector, nodes.front()) + radius_of(sector, nodes.back()));
  const double edge = 0.5 * sector.pitch();
  const Eigen::Vector2d trailing = point_at(sector, radius, -edge);
  const Eigen::Vector2d leading = point_at(sector, radius, edge);
  const double gap = (shifted_by_pitches(sector, nodes.front(), 1) - nodes.back()).norm();
  if (gap > rounding || (nodes.front() - trailing).norm() > at_edge ||
      (nodes.back() - leading).norm() > at_edge) {
    nodes.front() = trailing;
    nodes.back() = leading;
  }
}

}  // namespace

LinerProfile completed_profile(const LinerSector& sector, std::vector<Eigen::Vector2d> nodes,
                               double tolerance) {
  if (nodes.size() < 3) {
    throw InputError(
        fmt::format("the profile has {} nodes (a lifter takes at least 3); add the missing ones",
                    nodes.size()));
  }
  if (angle_of(sector, nodes.front()) >= angle_of(sector, nodes.back())) {
    throw InputError(fmt::format(
        "the profile runs against the direction of rotation (xi from {:.4g} to {:.4g} m); list its "
        "nodes from the trailing side to the leading one",
        nodes.front().x(), nodes.back().x()));
  }
  for (int side = 0; side < 2; ++side) {
    cut_at_trailing_edge(sector, nodes);
    mirror(nodes);
  }

  const double edge = 0.5 * sector.pitch();
  const auto off_edge = [&](const Eigen::Vector2d& node) {
    return (edge - std::abs(angle_of(sector, node))) * radius_of(sector, node);
  };
  const auto off_plate = [&](const Eigen::Vector2d& node) {
    return radius_of(sector, node) - sector.plate_radius;
  };
  const Eigen::Vector2d& trailing = nodes.front();
  const Eigen::Vector2d& leading = nodes.back();
  const double radius_gap = radius_of(sector, leading) - radius_of(sector, trailing);
  const bool at_edges =
      std::abs(off_edge(trailing)) <= tolerance && std::abs(off_edge(leading)) <= tolerance;
  if (at_edges && std::abs(radius_gap) <= tolerance) {
    snap_to_edges(sector, nodes);
  } else if (!at_edges && std::abs(off_plate(trailing)) <= tolerance &&
             std::abs(off_plate(leading)) <= tolerance) {
    const bool is_plate = std::ranges::all_of(
        nodes, [&](const Eigen::Vector2d& node) { return off_plate(node) >= -tolerance; });
    if (is_plate)
      throw InputError(
          fmt::format("no lifter stands on the profile: all of it lies within {:g} mm of the "
                      "plate, and it ends "
                      "before the sector edges; is a part of it missing?",
                      tolerance * 1e3));
    for (int side = 0; side < 2; ++side) {
      if (off_edge(nodes.front()) > tolerance) {
        extend_to_trailing_edge(sector, nodes);
      }
      mirror(nodes);
    }
    snap_to_edges(sector, nodes);
  } else if (at_edges) {
    throw InputError(fmt::format(
        "the profile's two ends do not meet (radius {:.3f} mm larger at the leading sector edge "
        "than at the trailing one, {:g} mm at most); they are one point of two neighbouring "
        "pitches",
        radius_gap * 1e3, tolerance * 1e3));
  } else {
    throw InputError(fmt::format(
        "the profile ends neither on the plate nor at the sector edges (its ends lie {:.3f} and "
        "{:.3f} mm from the plate's circle, {:.1f} and {:.1f} mm from the edges, {:g} mm at most); "
        "end "
        "it on the plate, or {:.4f} m of plate before and behind the lifter's centre",
        off_plate(trailing) * 1e3, off_plate(leading) * 1e3, off_edge(trailing) * 1e3,
        off_edge(leading) * 1e3, tolerance * 1e3, edge * sector.plate_radius));
  }
  return {sector, std::move(nodes)};
}

}  // namespace millwear
