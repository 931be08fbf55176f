#include "mill/load/contact_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace millwear {
namespace {

bool is_at_limit(double tangential_force, double normal_force, const LinerFriction& friction) {
  constexpr double rounding = 1e-6;
  return tangential_force >= (1.0 - rounding) * friction.coefficient * std::abs(normal_force);
}

}  // namespace

ContactMotion contact_motion(const Eigen::Vector3d& arm, double radius,
                             const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) {
  const double length = arm.norm();
  const Eigen::Vector3d into_wall = arm / length;
  const Eigen::Vector3d surface = velocity + 0.5 * (radius + length) * spin.cross(into_wall);
  const double closing = surface.dot(into_wall);
  return {into_wall, closing, surface - closing * into_wall, velocity.norm(), radius - length};
}

double sliding_speed(const ContactMotion& motion, const Eigen::Vector3d& tangential_force,
                     double normal_force, const LinerFriction& friction) {
  const double force = tangential_force.norm();
  const double power = -tangential_force.dot(motion.slip);
  if (friction.coefficient == 0.0) return motion.slip.norm();
  if (force == 0.0) return 0.0;
  if (is_at_limit(force, normal_force, friction)) return power / force;
  const double damping = tangential_damping(friction, motion.overlap);
  return (power - damping * motion.slip.squaredNorm()) /
         (friction.coefficient * std::abs(normal_force));
}

double path_speed(const ContactMotion& motion, const Eigen::Vector3d& tangential_force,
                  double normal_force, const LinerFriction& friction) {
  const bool slips = is_at_limit(tangential_force.norm(), normal_force, friction);
  return slips ? motion.slip.norm() : 0.0;
}

double finnie_power(const Eigen::Vector3d& velocity, const Eigen::Vector3d& arm,
                    const Eigen::Vector3d& wall_normal, double force) {
  constexpr double least_speed = 1e-7;
  const double speed = velocity.norm();
  if (velocity.dot(arm) < 0.0 || speed < least_speed) return 0.0;
  const double sine = std::min(1.0, std::abs(velocity.dot(wall_normal)) / speed);
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double fraction =
      3.0 * sine > cosine ? cosine * cosine / 3.0 : 2.0 * sine * cosine - 3.0 * sine * sine;
  return 2.0 * fraction * speed * force;
}

}  // namespace millwear
