#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "mill/load/steady_mixing.h"

namespace millwear {

/// The lines that millwear-recorder prints of how far it is, and how they are read back by who
/// follows it. Errors and drifts are printed as per cent in two digits.

/// Where a measurement goes on to.
struct NextEnd {
  long step;           ///< it is decided anew there
  long expected_step;  ///< it is likely to end there
  bool operator==(const NextEnd&) const = default;
};

/// What is decided where a measurement that may go on has come to its last step.
struct MeasuringLine {
  long step;
  double peak_error;            ///< relative standard error of the rate of loss at its peaks
  double target_error;          ///< likewise
  std::optional<NextEnd> next;  ///< none: the measurement ends
};

/// "millwear: step 4000, rate at its peaks known to 7.1 % (target 5 %), going on to step 5000,
/// perhaps to 8000", or "..., the measurement ends".
[[nodiscard]] std::string printed(const MeasuringLine& line);

/// None for any other line.
[[nodiscard]] std::optional<MeasuringLine> measuring_line(std::string_view line);

/// How far the charge drifts after a piece of a mixing that ends once it is steady.
struct MixingLine {
  long step;
  std::optional<MixingDrift> drift;  ///< none: it is too early to tell
};

/// "millwear: step 800, torque drifts by 2.1 % (limit 5 %), kinetic energy by 0.8 % (limit 5 %)",
/// or
/// "..., too early to tell a drift".
[[nodiscard]] std::string printed(const MixingLine& line);

/// None for any other line.
[[nodiscard]] std::optional<MixingLine> mixing_line(std::string_view line);

}  // namespace millwear
