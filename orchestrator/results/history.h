#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"

namespace millwear::orchestrator {

/// The liner after one geometry step, and what the charge did on the load that the step was taken
/// on. NaN where a value is not known (no feed rate, no standard error).
struct HistoryRow {
  int cycle;
  int step;
  double operating_hours;  ///< since the liner was new [h]
  double calendar_hours;   ///< likewise, with the time that the mill stood still [h]
  double tonnes;           ///< milled since then [t]
  double lifter_height;    ///< [m]
  double face_angle;       ///< leading face against the radial direction [rad]
  double plate_thickness;  ///< least steel over the shell [m]
  double worn_volume;      ///< per lifter and metre of mill, since new [m3/m]
  double worn_fraction;    ///< of the new lifter's volume, since new [-]
  double roughness;        ///< to the smallest particle, see wear/surface/roughness.h [m]
  double power;            ///< drawn by the simulated slice [W]
  double shoulder;         ///< from three o'clock on the rising side, along the rotation [rad]
  double toe;              ///< likewise [rad]
  double power_error;      ///< standard errors, in the units of their values
  double shoulder_error;
  double toe_error;
  double lifter_height_error;  ///< from the scatter of the loads up to here, see docs/physics.md
  double plate_thickness_error;
  double worn_volume_error;
  double airborne_share;  ///< of the charge's mass, see wear/record/charge_motion.h [-]
  double airborne_share_error;
  double bare_hit_power;  ///< of hits on the bare liner from flight [W]
  double bare_hit_power_error;
  double dead_zone_share;  ///< of the ascending charge, what moves with the mill [-]
  double dead_zone_share_error;
  double between_locked_share;  ///< the same of what is between the lifters [-]
  double between_locked_share_error;
  double speed;          ///< of the mill [1/min]
  double total_filling;  ///< of the volume inside the new plate [-]
  double feed_rate;      ///< at the end of the step [t/h]
};

/// The columns of `history.csv`, which its header, writer and reader come from.
[[nodiscard]] std::span<const CsvColumn<HistoryRow>> history_columns();

/// The bytes of `history.csv`; the same rows always give the same bytes.
[[nodiscard]] std::string history_csv(const std::vector<HistoryRow>& rows);

/// Reads `history.csv` back. Throws DiskError or ResultRejected (file:line).
[[nodiscard]] std::vector<HistoryRow> read_history_csv(const std::filesystem::path& path);

}  // namespace millwear::orchestrator
