#include "mill/liner/profile_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace millwear {
namespace {

/// A polar frame about the mill's axis: x towards the lifter, y along the direction of rotation.
Eigen::Vector2d about_axis(const LinerSector& sector, const Eigen::Vector2d& point) {
  return {sector.plate_radius - point.y(), point.x()};
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Interval {
  double from;
  double to;
};

/// The part of the segment a + t (b - a), t in [0, 1], within `radius` of the origin.
std::optional<Interval> part_inside_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                           double radius) {
  const Eigen::Vector2d d = b - a;
  const double length2 = d.squaredNorm();
  if (length2 == 0.0) {
    return std::nullopt;
  }
  const double middle = -a.dot(d) / length2;
  const double half2 = middle * middle - (a.squaredNorm() - radius * radius) / length2;
  if (half2 <= 0.0) {
    return std::nullopt;
  }
  const Interval part{std::max(0.0, middle - std::sqrt(half2)),
                      std::min(1.0, middle + std::sqrt(half2))};
  return part.from < part.to ? std::optional(part) : std::nullopt;
}

/// Signed area common to the triangle (origin, a, b) and the disc of `radius` about the origin.
double area_in_disc(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius) {
  const auto sector_between = [radius](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return 0.5 * radius * radius * std::atan2(cross(p, q), p.dot(q));
  };
  const std::optional<Interval> inside = part_inside_circle(a, b, radius);
  if (!inside) {
    return sector_between(a, b);
  }
  const Eigen::Vector2d enter = a + inside->from * (b - a);
  const Eigen::Vector2d leave = a + inside->to * (b - a);
  return sector_between(a, enter) + 0.5 * cross(enter, leave) + sector_between(leave, b);
}

struct Crest {
  std::size_t segment;       ///< from node `segment` to the next
  Eigen::Vector2d position;  ///< (xi, eta) [m]
  double radius;             ///< distance from the mill's axis [m]
};

/// The place of the profile nearest to the mill's axis.
Crest crest_of(const LinerProfile& profile) {
  const Eigen::Vector2d axis(0.0, profile.sector.plate_radius);
  Crest crest{0, profile.nodes.front(), radius_of(profile.sector, profile.nodes.front())};
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const Eigen::Vector2d& a = profile.nodes[i];
    const Eigen::Vector2d d = profile.nodes[i + 1] - a;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((axis - a).dot(d) / length2, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d place = a + t * d;
    const double radius = (axis - place).norm();
    if (radius < crest.radius) {
      crest = {i, place, radius};
    }
  }
  return crest;
}

double edge_radius(const LinerProfile& profile) {
  return 0.5 * (radius_of(profile.sector, profile.nodes.front()) +
                radius_of(profile.sector, profile.nodes.back()));
}

}  // namespace

double steel_area(const LinerProfile& profile) {
  const LinerSector& sector = profile.sector;
  double open = 0.0;
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    open +=
        0.5 * cross(about_axis(sector, profile.nodes[i]), about_axis(sector, profile.nodes[i + 1]));
  }
  return 0.5 * sector.shell_radius * sector.shell_radius * sector.pitch() - open;
}

double lifter_area(const LinerProfile& profile) {
  const LinerSector& sector = profile.sector;
  double open = 0.0;
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    open += area_in_disc(about_axis(sector, profile.nodes[i]),
                         about_axis(sector, profile.nodes[i + 1]), sector.plate_radius);
  }
  return 0.5 * sector.plate_radius * sector.plate_radius * sector.pitch() - open;
}

double crest_radius(const LinerProfile& profile) { return crest_of(profile).radius; }

double lifter_height(const LinerProfile& profile) {
  return profile.sector.plate_radius - crest_radius(profile);
}

double plate_thickness(const LinerProfile& profile) {
  double outermost = 0.0;
  for (const Eigen::Vector2d& node : profile.nodes) {
    outermost = std::max(outermost, radius_of(profile.sector, node));
  }
  return profile.sector.shell_radius - outermost;
}

double leading_face_angle(const LinerProfile& profile) {
  const LinerSector& sector = profile.sector;
  const Crest crest = crest_of(profile);
  const double height = edge_radius(profile) - crest.radius;
  const double outermost = edge_radius(profile) - 0.2 * height;
  const double highest_eta = crest.position.y() - 0.2 * height;

  double length = 0.0;
  Eigen::Vector2d first_moment = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second_moment = Eigen::Matrix2d::Zero();
  for (std::size_t i = crest.segment; i + 1 < profile.nodes.size(); ++i) {
    const Eigen::Vector2d a = i == crest.segment ? crest.position : profile.nodes[i];
    const Eigen::Vector2d d = profile.nodes[i + 1] - a;
    std::optional<Interval> part =
        part_inside_circle(about_axis(sector, a), about_axis(sector, a + d), outermost);
    if (!part) {
      continue;
    }
    if (d.y() != 0.0) {
      const double t = (highest_eta - a.y()) / d.y();
      (d.y() < 0.0 ? part->from : part->to) =
          d.y() < 0.0 ? std::max(part->from, t) : std::min(part->to, t);
    } else if (a.y() > highest_eta) {
      continue;
    }
    if (part->from >= part->to) {
      continue;
    }
    const Eigen::Vector2d p = a + part->from * d - crest.position;
    const Eigen::Vector2d q = a + part->to * d - crest.position;
    const double piece = (q - p).norm();
    length += piece;
    first_moment += 0.5 * piece * (p + q);
    second_moment +=
        piece / 6.0 *
        (2.0 * p * p.transpose() + 2.0 * q * q.transpose() + p * q.transpose() + q * p.transpose());
  }
  if (length == 0.0) {
    return 0.5 * std::numbers::pi;
  }
  const Eigen::Matrix2d scatter = second_moment - first_moment * first_moment.transpose() / length;
  const double principal = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  const double from_radial = 0.5 * std::numbers::pi - principal;
  return -std::remainder(from_radial, std::numbers::pi);
}

}  // namespace millwear
