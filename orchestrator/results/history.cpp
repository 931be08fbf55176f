#include "orchestrator/results/history.h"

#include <fmt/format.h>

#include "mill/base/csv.h"

namespace millwear::orchestrator {
namespace {

constexpr CsvFormat format{
    "millwear history 3",
    "cycle,step,operating_hours,tonnes,lifter_height_m,face_angle_deg,plate_thickness_m,"
    "worn_volume_m3_per_m,worn_fraction,power_w,shoulder_deg,toe_deg,"
    "power_w_se,shoulder_deg_se,toe_deg_se,lifter_height_m_se,plate_thickness_m_se,"
    "worn_volume_m3_per_m_se,airborne_share,airborne_share_se,bare_hit_power_w,"
    "bare_hit_power_w_se,dead_zone_share,dead_zone_share_se,between_lifters_locked_share,"
    "between_lifters_locked_share_se"};

}  // namespace

std::string history_csv(const std::vector<HistoryRow>& rows) {
  std::string text = csv_head(format);
  for (const auto& row : rows)
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
        row.cycle, row.step, csv_number(row.operating_hours), csv_number(row.tonnes),
        csv_number(row.lifter_height), csv_degrees(row.face_angle), csv_number(row.plate_thickness),
        csv_number(row.worn_volume), csv_number(row.worn_fraction), csv_number(row.power),
        csv_degrees(row.shoulder), csv_degrees(row.toe), csv_number(row.power_error),
        csv_degrees(row.shoulder_error), csv_degrees(row.toe_error),
        csv_number(row.lifter_height_error), csv_number(row.plate_thickness_error),
        csv_number(row.worn_volume_error), csv_number(row.airborne_share),
        csv_number(row.airborne_share_error), csv_number(row.bare_hit_power),
        csv_number(row.bare_hit_power_error), csv_number(row.dead_zone_share),
        csv_number(row.dead_zone_share_error), csv_number(row.between_locked_share),
        csv_number(row.between_locked_share_error));
  return text;
}

std::vector<HistoryRow> read_history_csv(const std::filesystem::path& path) {
  std::vector<HistoryRow> rows;
  for (const auto& line : read_csv(path, format)) {
    CsvFields fields(path, line);
    rows.push_back({.cycle = fields.integer(),
                    .step = fields.integer(),
                    .operating_hours = fields.number(),
                    .tonnes = fields.number(),
                    .lifter_height = fields.number(),
                    .face_angle = fields.degrees(),
                    .plate_thickness = fields.number(),
                    .worn_volume = fields.number(),
                    .worn_fraction = fields.number(),
                    .power = fields.number(),
                    .shoulder = fields.degrees(),
                    .toe = fields.degrees(),
                    .power_error = fields.number(),
                    .shoulder_error = fields.degrees(),
                    .toe_error = fields.degrees(),
                    .lifter_height_error = fields.number(),
                    .plate_thickness_error = fields.number(),
                    .worn_volume_error = fields.number(),
                    .airborne_share = fields.number(),
                    .airborne_share_error = fields.number(),
                    .bare_hit_power = fields.number(),
                    .bare_hit_power_error = fields.number(),
                    .dead_zone_share = fields.number(),
                    .dead_zone_share_error = fields.number(),
                    .between_locked_share = fields.number(),
                    .between_locked_share_error = fields.number()});
  }
  return rows;
}

}  // namespace millwear::orchestrator
