#include "mill/liner/parametric_lifter.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mill/base/failure.h"

namespace millwear {
namespace {

/// Where a face that starts at (top_half_width, height) and runs outwards and down meets the
/// plate's circle: the positive root t, the drop from the top, of
///     (w/2 + t tan a)^2 + (R - h + t)^2 = R^2.
Eigen::Vector2d foot_of(double plate_radius, double height, double top_half_width, double angle) {
  const double slope = std::tan(angle);
  const double depth = plate_radius - height;
  const double a = 1.0 + slope * slope;
  const double b = 2.0 * (top_half_width * slope + depth);
  const double c = top_half_width * top_half_width + depth * depth - plate_radius * plate_radius;
  const double drop = -2.0 * c / (b + std::sqrt(b * b - 4.0 * a * c));
  return {top_half_width + drop * slope, height - drop};
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
  const double half_top = 0.5 * lifter.top_width;
  const Eigen::Vector2d leading =
      foot_of(sector.plate_radius, lifter.height, half_top, lifter.leading_face_angle);
  const Eigen::Vector2d trailing =
      foot_of(sector.plate_radius, lifter.height, half_top, lifter.trailing_face_angle)
          .cwiseProduct(Eigen::Vector2d(-1.0, 1.0));
  const double leading_foot = angle_of(sector, leading);
  const double trailing_foot = -angle_of(sector, trailing);
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
  append({trailing, {-half_top, lifter.height}, {half_top, lifter.height}, leading});
  if (plate == PlateShape::arc) {
    append(nodes_between(sector, sector.plate_radius, leading_foot, edge));
  }
  profile.nodes.push_back(point_at(sector, edge_radius, edge));
  return profile;
}

}  // namespace millwear
