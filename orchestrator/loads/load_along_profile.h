#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/rotation.h"
#include "wear/rate/load_rate.h"

namespace millwear::orchestrator {

/// One measure along the profile, a value a bin. Any vector may be empty.
struct LoadLine {
  std::vector<double> raw;             ///< as accumulated
  std::vector<double> standard_error;  ///< of `raw`, from the time blocks
  std::vector<double> smoothed;
  std::vector<double> smoothed_error;  ///< standard error of `smoothed`
};

/// The load of one cycle on the master lifter.
struct LoadAlongProfile {
  int cycle;
  std::vector<double> arc_length;        ///< of bin centres from the trailing sector edge [m]
  std::vector<double> width;             ///< of bins [m]
  std::vector<Eigen::Vector2d> centres;  ///< of bins, master frame (xi, eta) [m]
  LoadLine contacts;                     ///< contact samples per metre of profile [1/m]
  LoadLine normal_dissipation;           ///< int Fn v_n dt per lifter surface and time [W/m2]
  LoadLine sliding_work;                 ///< per lifter surface and time [W/m2]
  LoadLine depth_rate;                   ///< wear depth per running time [m/s]
};

/// The measures of a load, smoothed like its loss; `centres` is left empty, for it takes the liner.
[[nodiscard]] LoadAlongProfile load_along_profile(int cycle, const wear::LoadRate& rate);

/// Places of the bins in the steel's frame, as `liner` is, by their arc lengths on the liner as the
/// DEM turns it [m].
[[nodiscard]] std::vector<Eigen::Vector2d> bin_places(const LinerProfile& liner, Rotation rotation,
                                                      const std::vector<double>& arc_lengths);

}  // namespace millwear::orchestrator
