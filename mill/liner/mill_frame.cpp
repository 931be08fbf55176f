#include "mill/liner/mill_frame.h"

#include <cmath>
#include <numbers>

namespace millwear {

double angle_from_six_oclock(double x, double z) {
  const double angle = std::atan2(-x, -z);
  return angle == -std::numbers::pi ? std::numbers::pi : angle;
}

double from_three_oclock(double angle_from_six) {
  using std::numbers::pi;
  return std::fmod(angle_from_six + 1.5 * pi + 4.0 * pi, 2.0 * pi);
}

MasterPoint to_master_from_polar(const LinerSector& sector, double radius, double angle,
                                 double mill_angle) {
  const double turned_back = angle - mill_angle;
  const double pitches = std::floor(turned_back / sector.pitch() + 0.5);
  const double row = pitches - sector.rows * std::floor(pitches / sector.rows);
  return {point_at(sector, radius, turned_back - pitches * sector.pitch()), static_cast<int>(row)};
}

MasterPoint to_master(const LinerSector& sector, double x, double z, double mill_angle) {
  return to_master_from_polar(sector, std::hypot(x, z), angle_from_six_oclock(x, z), mill_angle);
}

Eigen::Vector2d to_mill(const LinerSector& sector, const Eigen::Vector2d& point, int row,
                        double mill_angle) {
  const double radius = radius_of(sector, point);
  const double angle = angle_of(sector, point) + row * sector.pitch() + mill_angle;
  return {-radius * std::sin(angle), -radius * std::cos(angle)};
}

}  // namespace millwear
