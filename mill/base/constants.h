#pragma once
#include <numbers>

namespace millwear {

/// Gravity of the closed forms and of the DEM deck (liggghts_inputs/decks/templates) [m/s2],
/// rounded from 9.80665, the standard value of the third General Conference on Weights and Measures
/// (1901).
inline constexpr double standard_gravity = 9.81;

/// Units that stand beside SI (The International System of Units, 9th edition, table 8).
inline constexpr double seconds_per_hour = 3600.0;     ///< [s/h]
inline constexpr double hours_per_day = 24.0;          ///< [h/d]
inline constexpr double seconds_per_day = 86400.0;     ///< [s/d]
inline constexpr double kilograms_per_tonne = 1000.0;  ///< [kg/t]
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// The Julian year of astronomy, the mean of the calendar's [d/year].
inline constexpr double days_per_year = 365.25;

inline constexpr double millimetres_per_metre = 1000.0;

/// Standard errors from the mean of a normal distribution to either end of its middle 95 % [-].
inline constexpr double errors_of_95_percent = 1.96;

}  // namespace millwear
