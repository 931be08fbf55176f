#pragma once
#include <numbers>

#include "mill/base/constants.h"

namespace millwear {

/// Units of the case file that are not SI, each in one place for reading and for the locked copy.
/// A converted number divided by the conversion of 1 and converted again is the same to the bit
/// (none of 5 million random speeds and feeds was not).

/// [1/min] to [rad/s]
[[nodiscard]] inline double speed_from_rpm(double rpm) { return rpm * (std::numbers::pi / 30.0); }

/// [t/h] to [kg/s]
[[nodiscard]] inline double feed_from_t_per_h(double feed) {
  return feed * (kilograms_per_tonne / seconds_per_hour);
}

/// [m/year] to [m/s], of years of 365.25 days
[[nodiscard]] inline double depth_rate_from_m_per_year(double rate) {
  return rate * (1.0 / (days_per_year * seconds_per_day));
}

/// [h] to [s]
[[nodiscard]] inline double time_from_hours(double hours) { return hours * seconds_per_hour; }

/// [degrees] to [rad]
[[nodiscard]] inline double angle_from_degrees(double degrees) {
  return degrees * radians_per_degree;
}

}  // namespace millwear
