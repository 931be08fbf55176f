#include "wear/calibrate/angular_zones.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace millwear::wear {
namespace {

/// Which zone of the endless row of zones around the mill, 0 the first of this pitch.
double position_of(const LinerSector& sector, const Eigen::Vector2d& point, Eigen::Index zones) {
  return (angle_of(sector, point) / sector.pitch() + 0.5) * static_cast<double>(zones);
}

Eigen::Index within_pitch(double zone, Eigen::Index zones) {
  const auto whole = static_cast<Eigen::Index>(zone) % zones;
  return whole < 0 ? whole + zones : whole;
}

/// Where the segment meets the ray from the axis at an angle: share of the way from a to b.
double share_at(const LinerSector& sector, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                double angle) {
  const Eigen::Vector2d axis(0.0, sector.plate_radius);
  const Eigen::Vector2d across(std::cos(angle), std::sin(angle));
  const double from = across.dot(a - axis);
  const double to = across.dot(b - axis);
  return std::clamp(from / (from - to), 0.0, 1.0);
}

/// Calls `add(zone, a, b)` for every segment of the profile, cut where zones meet.
template <typename Add>
void for_each_piece(const LinerProfile& profile, Eigen::Index zones, const Add& add) {
  const LinerSector& sector = profile.sector;
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const Eigen::Vector2d& a = profile.nodes[i];
    const Eigen::Vector2d& b = profile.nodes[i + 1];
    const double start = position_of(sector, a, zones);
    const double end = position_of(sector, b, zones);
    const double step = end >= start ? 1.0 : -1.0;
    double zone = step > 0.0 ? std::floor(start) : std::ceil(start) - 1.0;
    Eigen::Vector2d from = a;
    while (true) {
      const double border = step > 0.0 ? zone + 1.0 : zone;
      const bool ends_here = step > 0.0 ? end <= border : end >= border;
      const double angle = (border / static_cast<double>(zones) - 0.5) * sector.pitch();
      const Eigen::Vector2d to =
          ends_here ? b : Eigen::Vector2d(a + share_at(sector, a, b, angle) * (b - a));
      add(within_pitch(zone, zones), from, to);
      if (ends_here) break;
      from = to;
      zone += step;
    }
  }
}

}  // namespace

Eigen::Index zone_of(const LinerSector& sector, const Eigen::Vector2d& point, Eigen::Index zones) {
  return within_pitch(std::floor(position_of(sector, point, zones)), zones);
}

Eigen::VectorXd steel_by_zone(const LinerProfile& profile, Eigen::Index zones) {
  const LinerSector& sector = profile.sector;
  const double to_shell =
      0.5 * sector.shell_radius * sector.shell_radius * sector.pitch() / static_cast<double>(zones);
  Eigen::VectorXd steel = Eigen::VectorXd::Constant(zones, to_shell);
  const Eigen::Vector2d axis(0.0, sector.plate_radius);
  for_each_piece(profile, zones, [&](Eigen::Index zone, const auto& from, const auto& to) {
    const Eigen::Vector2d p = from - axis;
    const Eigen::Vector2d q = to - axis;
    steel[zone] -= 0.5 * (p.x() * q.y() - p.y() * q.x());
  });
  return steel;
}

Eigen::VectorXd length_by_zone(const LinerProfile& profile, Eigen::Index zones) {
  Eigen::VectorXd length = Eigen::VectorXd::Zero(zones);
  for_each_piece(profile, zones, [&](Eigen::Index zone, const auto& from, const auto& to) {
    length[zone] += (to - from).norm();
  });
  return length;
}

}  // namespace millwear::wear
