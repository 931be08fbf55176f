#pragma once
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wear/band/life_band.h"

namespace millwear::orchestrator {

/// What a gauge's height is measured from.
enum class GaugeOn {
  new_plate,  ///< from where the plate was when new, as `lifter_height`
  plate       ///< from the worn plate: height plus what the plate has lost
};

/// What a reading is to a calibration.
enum class CourseUse {
  fresh,       ///< of the new liner, from which prediction and line start
  calibrated,  ///< the factor was found from it
  held_out
};

/// "new", "calibrated" or "held out"
[[nodiscard]] std::string_view spoken(CourseUse use);

/// A value with its 95 % band; NaN where it is not known.
struct Banded {
  double value = std::numeric_limits<double>::quiet_NaN();
  wear::Band band{value, value};
};

/// A reading beside a campaign whose hours were calibrated. Heights are as the gauge reads them.
struct CourseReading {
  double operating_hours;  ///< [h]
  CourseUse use;
  std::optional<double> height;  ///< measured [m]
  double error;                  ///< of the reading's lengths [m]
  Banded predicted;              ///< height [m]; unknown after the campaign's last liner
  double line;                   ///< height by the straight line [m]
  std::optional<double> plate;   ///< measured [m]
  Banded predicted_plate;        ///< [m]
};

/// A height of the predicted curve.
struct CourseMoment {
  double operating_hours;  ///< [h]
  Banded height;           ///< [m]
};

/// A campaign with all coefficients of its wear law times one factor, found from the readings up
/// to some hours: its own hours divided by the factor.
struct CalibratedCourse {
  double until;  ///< [h]
  GaugeOn gauge_on;
  Banded factor;
  std::vector<CourseReading> readings;
  std::vector<CourseMoment> curve;  ///< a moment a geometry step
  double fresh_height;              ///< of the new liner [m]
  double line_rate;                 ///< of the straight line [m/h]
  int held_out;                     ///< readings of a height that are held out and predicted
  int beyond;                       ///< readings after the campaign's last liner, which say nothing
  double rms;                       ///< of predicted less measured heights that are held out [m]
  double line_rms;                  ///< of the straight line's, for the same readings [m]
  double mape;          ///< mean of |predicted less measured| / measured over these readings [-]
  double line_mape;     ///< of the straight line's, for the same readings [-]
  double height_limit;  ///< [m], from the new plate
  Banded life;          ///< to that height [h]; unknown where the campaign does not reach it
  double line_life;     ///< by the straight line; unknown for a gauge on the worn plate
  std::string verdict;  ///< prediction against straight line, in words
  std::vector<std::string> remarks;  ///< what to keep in mind with these figures
};

}  // namespace millwear::orchestrator
