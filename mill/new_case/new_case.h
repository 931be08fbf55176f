#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/base/length_unit.h"

namespace millwear {

/// A size class of a distribution: its diameter [m] and what is retained on it [%].
struct SizeShare {
  double diameter;
  double percent;
};

/// "90:39.9,63:47.3": diameters in mm and shares in percent, largest first. A diameter alone
/// ("100") is all of it. Throws InputError for anything else.
[[nodiscard]] std::vector<SizeShare> size_shares(std::string_view text);

/// A new liner in the words of who asks for a case.
struct NewLiner {
  std::optional<std::string> drawing;     ///< as the case file names it; else the shape below
  std::optional<LengthUnit> unit;         ///< of the drawing, in place of its own
  std::optional<double> height;           ///< [m]; with a drawing that of the drawn lifter
  std::optional<double> top_width;        ///< [m]
  std::optional<double> face_angle;       ///< of both faces [degrees]
  std::optional<double> plate_thickness;  ///< [m]
};

/// Thickness of the plate [m] that is assumed where none is given.
[[nodiscard]] double assumed_plate(double shell_diameter);

/// What is known of a mill. What is not given is assumed.
struct NewCase {
  std::string name;
  double shell_diameter;  ///< [m]
  int rows;
  std::optional<double> speed_rpm;          ///< [1/min]; else three quarters of critical
  std::optional<double> critical_fraction;  ///< in its place
  NewLiner liner;
  double filling;                      ///< J [-]
  std::optional<double> ball_filling;  ///< [-]; where there is ore too
  std::vector<SizeShare> balls;
  std::vector<SizeShare> ore;
};

/// A complete case file with a comment on every line: "given", how it is derived, or what is
/// assumed. Throws InputError where balls and ore are both missing, or one filling does not tell
/// how much of each there is.
[[nodiscard]] std::string new_case_text(const NewCase& wanted);

}  // namespace millwear
