#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "mill/case/operating_change.h"

namespace millwear {

/// How the next DEM is timed.
enum class Scheme {
  threshold,  ///< after a worn share of the lifter, the load standing still (the 2006 paper)
  adaptive,   ///< second order in time, with the step set by the error of the last
};

/// As the case file writes it.
[[nodiscard]] std::string_view name_of(Scheme scheme);

/// When to run the DEM anew, and when to stop. The defaults are those of the case file.
struct CampaignSettings {
  double threshold = 0.15;  ///< worn share of the new lifter's volume per DEM load
  int steps_per_cycle = 5;  ///< geometry steps on one DEM load
  double height_limit;      ///< the liner is worn out at this lifter height [m]
  double plate_limit;       ///< ... or at this least plate thickness [m]
  int cycle_limit = 50;     ///< stop after so many cycles
  Scheme scheme = Scheme::threshold;
  double step_tolerance = 0.005;  ///< adaptive: share of the new lifter's volume that one load may
                                  ///< wear at the wrong place
  double largest_share = 0.25;    ///< adaptive: ... that one load may wear at all
  std::vector<double> reversal_times = {};  ///< of milling, at which the rotation turns to the
                                            ///< other way, increasing [s] (mill/liner/rotation.h)
  std::vector<OperatingChange> operation = {};   ///< other speeds, fillings, feed rates and stops
  std::optional<double> target_life_error = {};  ///< half width of the life's 95 % band [-]
};

}  // namespace millwear
