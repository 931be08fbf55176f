#include "mill/liner/liner_profile.h"

#include <cmath>
#include <numbers>

namespace millwear {

double LinerSector::pitch() const { return 2.0 * std::numbers::pi / rows; }

double radius_of(const LinerSector& sector, const Eigen::Vector2d& point) {
  return std::hypot(point.x(), sector.plate_radius - point.y());
}

double angle_of(const LinerSector& sector, const Eigen::Vector2d& point) {
  return std::atan2(point.x(), sector.plate_radius - point.y());
}

Eigen::Vector2d point_at(const LinerSector& sector, double radius, double angle) {
  return {radius * std::sin(angle), sector.plate_radius - radius * std::cos(angle)};
}

Eigen::Vector2d shifted_by_pitches(const LinerSector& sector, const Eigen::Vector2d& point,
                                   int pitches) {
  return point_at(sector, radius_of(sector, point),
                  angle_of(sector, point) + pitches * sector.pitch());
}

std::vector<double> arc_lengths(const LinerProfile& profile) {
  std::vector<double> lengths(profile.nodes.size(), 0.0);
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    lengths[i] = lengths[i - 1] + (profile.nodes[i] - profile.nodes[i - 1]).norm();
  }
  return lengths;
}

LinerProfile mirrored(const LinerProfile& profile) {
  LinerProfile result{profile.sector, {profile.nodes.rbegin(), profile.nodes.rend()}};
  for (Eigen::Vector2d& node : result.nodes) {
    node.x() = -node.x();
  }
  return result;
}

}  // namespace millwear
