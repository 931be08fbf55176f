#pragma once
#include <cmath>
#include <numbers>

namespace millwear {

/// Units of the case file that are not SI, each in one place for reading and for the locked copy.

/// [1/min] to [rad/s]
[[nodiscard]] inline double speed_from_rpm(double rpm) { return rpm * (std::numbers::pi / 30.0); }

/// [t/h] to [kg/s]
[[nodiscard]] inline double feed_from_t_per_h(double feed) { return feed * (1000.0 / 3600.0); }

/// [degrees] to [rad]
[[nodiscard]] inline double angle_from_degrees(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

/// The number whose conversion is `value` to the last bit, where `value` came from one by `convert`
/// (a multiplication); else the nearest.
template <typename Convert>
[[nodiscard]] double unconverted(double value, const Convert& convert) {
  const double near = value / convert(1.0);
  double below = near;
  double above = near;
  for (int ulps = 0; ulps < 4; ++ulps) {
    if (convert(below) == value) {
      return below;
    }
    if (convert(above) == value) {
      return above;
    }
    below = std::nextafter(below, -HUGE_VAL);
    above = std::nextafter(above, HUGE_VAL);
  }
  return near;
}

}  // namespace millwear
