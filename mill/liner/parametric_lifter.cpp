#include "mill/liner/parametric_lifter.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "mill/base/failure.h"

namespace millwear {
namespace {

/// One half of a lifter, from its top to its foot on the plate; the leading one, or the trailing
/// one mirrored.
struct LifterSide {
  std::vector<Eigen::Vector2d> nodes;
  double foot;  ///< angle of its last node about the mill's axis [rad]
};

/// Drop t along the direction (tan, -1) from (across, up) to the circle of `radius` about the
/// mill's axis: the positive root of
///     (across + t tan)^2 + (plate_radius - up + t)^2 = radius^2.
double drop_to_circle(double plate_radius, const Eigen::Vector2d& from, double slope,
                      double radius) {
  const double depth = plate_radius - from.y();
  const double a = 1.0 + slope * slope;
  const double b = 2.0 * (from.x() * slope + depth);
  const double c = from.x() * from.x() + depth * depth - radius * radius;
  return -2.0 * c / (b + std::sqrt(b * b - 4.0 * a * c));
}

/// Nodes on a circle from one place to another, by the shorter way.
std::vector<Eigen::Vector2d> fillet(const Eigen::Vector2d& centre, const Eigen::Vector2d& from,
                                    const Eigen::Vector2d& to) {
  constexpr double share_of_radius = 0.01;
  const Eigen::Vector2d first = from - centre;
  const Eigen::Vector2d last = to - centre;
  const double turn = std::atan2(first.x() * last.y() - first.y() * last.x(), first.dot(last));
  const double longest = 2.0 * std::acos(1.0 - share_of_radius);
  const int facets = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / longest)));
  std::vector<Eigen::Vector2d> nodes;
  for (int i = 0; i <= facets; ++i)
    nodes.emplace_back(centre + Eigen::Rotation2Dd(turn * i / facets) * first);
  return nodes;
}

[[noreturn]] void refuse_radius(std::string_view key, double radius) {
  throw InputError(fmt::format("no room for `{}` of {:.4g} m; lower it", key, radius));
}

LifterSide side_of(double plate_radius, const ParametricLifter& lifter, double face_angle) {
  const double slope = std::tan(face_angle);
  const Eigen::Vector2d outward(std::cos(face_angle), std::sin(face_angle));
  const Eigen::Vector2d top(0.5 * lifter.top_width, lifter.height);
  const Eigen::Vector2d down(slope, -1.0);
  LifterSide side{{top}, 0.0};
  if (lifter.top_radius > 0.0) {
    const double y = lifter.height - lifter.top_radius;
    const double x = top.x() - (lifter.top_radius + (y - top.y()) * outward.y()) / outward.x();
    if (x < 0.0) refuse_radius("top_radius_m", lifter.top_radius);
    side.nodes =
        fillet({x, y}, {x, lifter.height}, Eigen::Vector2d(x, y) + lifter.top_radius * outward);
  }
  const Eigen::Vector2d offset = top + lifter.foot_radius * outward;
  const double drop =
      drop_to_circle(plate_radius, offset, slope, plate_radius - lifter.foot_radius);
  const Eigen::Vector2d centre = offset + drop * down;
  const Eigen::Vector2d on_face = centre - lifter.foot_radius * outward;
  if (lifter.foot_radius > 0.0 && !(on_face.y() < side.nodes.back().y()))
    refuse_radius(lifter.top_radius > lifter.foot_radius ? "top_radius_m" : "foot_radius_m",
                  std::max(lifter.top_radius, lifter.foot_radius));
  if (lifter.foot_radius > 0.0) {
    const Eigen::Vector2d axis(0.0, plate_radius);
    const Eigen::Vector2d on_plate = axis + plate_radius * (centre - axis).normalized();
    const auto arc = fillet(centre, on_face, on_plate);
    side.nodes.insert(side.nodes.end(), arc.begin(), arc.end());
  } else {
    if (!(on_face.y() < side.nodes.back().y())) refuse_radius("top_radius_m", lifter.top_radius);
    side.nodes.push_back(on_face);
  }
  const Eigen::Vector2d& foot = side.nodes.back();
  side.foot = std::atan2(foot.x(), plate_radius - foot.y());
  return side;
}

/// The place where the straight line from one foot to the next lifter's foot passes the sector
/// edge.
double edge_radius_of_straight_plate(const LinerSector& sector, double leading_foot,
                                     double trailing_foot) {
  const double half_gap = 0.5 * (sector.pitch() - leading_foot - trailing_foot);
  const double middle = leading_foot + half_gap;
  return sector.plate_radius * std::cos(half_gap) / std::cos(0.5 * sector.pitch() - middle);
}

void check(const LinerSector& sector, const ParametricLifter& lifter) {
  if (lifter.height >= sector.plate_radius) {
    throw InputError(
        fmt::format("the lifter reaches the mill's axis (height {:.4g} m, radius on the plate "
                    "{:.4g} m); lower `height_m`",
                    lifter.height, sector.plate_radius));
  }
  if (std::hypot(0.5 * lifter.top_width, sector.plate_radius - lifter.height) >=
      sector.plate_radius) {
    throw InputError(
        fmt::format("the lifter's top corners lie under the plate (top {:.4g} m wide, {:.4g} m "
                    "high); lower `top_width_m` or raise `height_m`",
                    lifter.top_width, lifter.height));
  }
}

}  // namespace

std::vector<Eigen::Vector2d> nodes_between(const LinerSector& sector, double radius, double from,
                                           double to) {
  const double longest = 2.0 * std::acos(1.0 - plate_sagitta / radius);
  const int facets = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  std::vector<Eigen::Vector2d> nodes;
  for (int i = 1; i < facets; ++i) {
    nodes.push_back(point_at(sector, radius, from + (to - from) * i / facets));
  }
  return nodes;
}

LinerProfile profile_of(const LinerSector& sector, const ParametricLifter& lifter,
                        PlateShape plate) {
  check(sector, lifter);
  const LifterSide leading = side_of(sector.plate_radius, lifter, lifter.leading_face_angle);
  const LifterSide trailing = side_of(sector.plate_radius, lifter, lifter.trailing_face_angle);
  const double leading_foot = leading.foot;
  const double trailing_foot = trailing.foot;
  const double edge = 0.5 * sector.pitch();
  if (leading_foot >= edge || trailing_foot >= edge) {
    const double base = 2.0 * std::max(leading_foot, trailing_foot) * sector.plate_radius;
    throw InputError(fmt::format(
        "lifters overlap ({} rows of {:.3g} m need {:.4g} m, the plate has {:.4g} m around); lower "
        "`rows`, `top_width_m` or the face angles",
        sector.rows, base, sector.rows * base, 2.0 * std::numbers::pi * sector.plate_radius));
  }

  LinerProfile profile{sector, {}};
  const auto append = [&profile](const std::vector<Eigen::Vector2d>& nodes) {
    profile.nodes.insert(profile.nodes.end(), nodes.begin(), nodes.end());
  };
  const double edge_radius =
      plate == PlateShape::arc ? sector.plate_radius
                               : edge_radius_of_straight_plate(sector, leading_foot, trailing_foot);
  profile.nodes.push_back(point_at(sector, edge_radius, -edge));
  if (plate == PlateShape::arc) {
    append(nodes_between(sector, sector.plate_radius, -edge, -trailing_foot));
  }
  for (auto node = trailing.nodes.rbegin(); node != trailing.nodes.rend(); ++node)
    profile.nodes.emplace_back(-node->x(), node->y());
  append(leading.nodes);
  if (plate == PlateShape::arc) {
    append(nodes_between(sector, sector.plate_radius, leading_foot, edge));
  }
  profile.nodes.push_back(point_at(sector, edge_radius, edge));
  return profile;
}

}  // namespace millwear
