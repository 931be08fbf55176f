#include "orchestrator/results/history.h"

#include <array>

namespace millwear::orchestrator {
namespace {

using Row = HistoryRow;
using Degrees = InDegrees<Row>;

constexpr std::string_view history_format = "millwear history 5";
constexpr std::array<CsvColumn<Row>, 31> columns{{
    {"cycle", "1", "DEM load that the step was taken on, from 0", "cycle", &Row::cycle},
    {"step", "1", "geometry step within the cycle", "step", &Row::step},
    {"operating_hours", "h", "since the liner was new", "operating_hours", &Row::operating_hours},
    {"calendar_hours", "h", "likewise, with the idle times of the operation", "calendar_hours",
     &Row::calendar_hours},
    {"tonnes", "t", "milled by then; empty without a feed rate", "tonnes", &Row::tonnes},
    {"lifter_height_m", "m",
     "crest above where the plate was when new; it only falls, and goes below 0 when the crest is "
     "under the new plate",
     "lifter_height", &Row::lifter_height},
    {"face_angle_deg", "degree",
     "mean inclination of the face that leads in this cycle (after a reversal, the other one) "
     "against the radial direction, 0 upright; least squares between 20 and 80 % of the height",
     "face_angle", Degrees{&Row::face_angle}},
    {"plate_thickness_m", "m", "least steel over the shell anywhere", "plate_thickness",
     &Row::plate_thickness},
    {"worn_volume_m3_per_m", "m3/m",
     "steel lost since new, per lifter and metre of mill; lifter and plate", "worn_volume",
     &Row::worn_volume},
    {"worn_fraction", "1", "share of the new lifter's steel above the new plate that is gone",
     "worn_fraction", &Row::worn_fraction},
    {"roughness_m", "m",
     "section between the liner and what the smallest particle touches of it, per length; a new "
     "lifter's feet count, a worn liner should have less ([numerics.md](numerics.md#roughness))",
     "roughness", &Row::roughness},
    {"power_w", "W", "drawn by the simulated slice", "power", &Row::power},
    {"shoulder_deg", "degree",
     "angle of the shoulder from three o'clock on the rising side, along the mill's rotation (six "
     "o'clock is 270)",
     "shoulder", Degrees{&Row::shoulder}},
    {"toe_deg", "degree", "angle of the toe, likewise", "toe", Degrees{&Row::toe}},
    {"power_w_se", "W", "standard error of `power_w`", "power_error", &Row::power_error},
    {"shoulder_deg_se", "degree", "standard error of `shoulder_deg`", "shoulder_error",
     Degrees{&Row::shoulder_error}},
    {"toe_deg_se", "degree", "standard error of `toe_deg`", "toe_error", Degrees{&Row::toe_error}},
    {"lifter_height_m_se", "m",
     "standard error of `lifter_height_m`, from the noise of all loads so far "
     "([physics.md](physics.md#the-band-of-a-life))",
     "lifter_height_error", &Row::lifter_height_error},
    {"plate_thickness_m_se", "m", "likewise of `plate_thickness_m`", "plate_thickness_error",
     &Row::plate_thickness_error},
    {"worn_volume_m3_per_m_se", "m3/m", "likewise of `worn_volume_m3_per_m`", "worn_volume_error",
     &Row::worn_volume_error},
    {"airborne_share", "1",
     "share of the charge's mass in free flight ([physics.md](physics.md#how-the-charge-moves)). "
     "Like all that follow, empty with `wall_contacts = \"dumps\"`",
     "airborne_share", &Row::airborne_share},
    {"airborne_share_se", "1", "standard error of `airborne_share`", "airborne_share_error",
     &Row::airborne_share_error},
    {"bare_hit_power_w", "W",
     "kinetic energy a second with which particles hit the bare liner from flight",
     "bare_hit_power", &Row::bare_hit_power},
    {"bare_hit_power_w_se", "W", "standard error of `bare_hit_power_w`", "bare_hit_power_error",
     &Row::bare_hit_power_error},
    {"dead_zone_share", "1", "of the ascending charge's mass, what moves with the mill",
     "dead_zone_share", &Row::dead_zone_share},
    {"dead_zone_share_se", "1", "standard error of `dead_zone_share`", "dead_zone_share_error",
     &Row::dead_zone_share_error},
    {"between_lifters_locked_share", "1",
     "the same of what ascends between the lifters; empty where no centre lies there",
     "between_locked_share", &Row::between_locked_share},
    {"between_lifters_locked_share_se", "1", "standard error of `between_lifters_locked_share`",
     "between_locked_share_error", &Row::between_locked_share_error},
    {"speed_rpm", "1/min", "of the mill", "speed", &Row::speed},
    {"total_filling", "1", "bulk volume of the charge, share of the volume inside the new plate",
     "total_filling", &Row::total_filling},
    {"feed_rate_t_per_h", "t/h", "at the end of the step; empty without a feed rate", "feed_rate",
     &Row::feed_rate},
}};

}  // namespace

std::span<const CsvColumn<HistoryRow>> history_columns() { return columns; }

std::string history_csv(const std::vector<HistoryRow>& rows) {
  return csv_table(history_format, history_columns(), rows);
}

std::vector<HistoryRow> read_history_csv(const std::filesystem::path& path) {
  return read_csv_table(path, history_format, history_columns());
}

}  // namespace millwear::orchestrator
