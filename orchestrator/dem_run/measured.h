#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wear/record/charge_motion.h"
#include "wear/record/charge_position.h"

namespace millwear::orchestrator {

/// What a measuring stretch tells besides the load on the liner.
struct Measured {
  double power;                      ///< drawn by the slice [W], mean over the measurement
  double power_error;                ///< its standard error from the time blocks [W]
  std::vector<double> power_times;   ///< since the measurement began [s]
  std::vector<double> power_series;  ///< [W], averaged since the time before
  wear::ChargePosition charge;
  long samples;
  double rejected_share;  ///< of the contacts, farther from the profile than the mesh can be
  double revolutions;     ///< over which it was measured
  double peak_error;      ///< relative standard error of the smoothed rate of loss at its peaks;
                          ///< NaN where it is not known
  std::optional<double> target_error{};  ///< what `peak_error` was to come down to
  wear::MotionMeasures motion = wear::unknown_motion();
};

/// Why a measurement ended where it did.
enum class MeasurementEnd {
  no_target,         ///< its length was given
  target_reached,    ///< its rate is known well enough
  most_revolutions,  ///< it might go on no longer
};

[[nodiscard]] MeasurementEnd end_of(const Measured& measured);
[[nodiscard]] std::string_view name_of(MeasurementEnd end);

/// "measured for 1.5 revolutions, rate at its peaks known to 4.6 % (target 5 %)"
[[nodiscard]] std::string spoken_end(const Measured& measured);

/// `measured.json`, written into a folder that is published later. Throws DiskError where the file
/// cannot be written, and ResultRejected where it cannot be understood.
void write_measured(const std::filesystem::path& file, const Measured& measured);
[[nodiscard]] Measured read_measured(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
