#include "orchestrator/results/history.h"

#include <array>

namespace millwear::orchestrator {
namespace {

using Row = HistoryRow;
using Degrees = InDegrees<Row>;

constexpr std::string_view history_format = "millwear history 3";
constexpr std::array<CsvColumn<Row>, 26> columns{{
    {"cycle", "1", &Row::cycle},
    {"step", "1", &Row::step},
    {"operating_hours", "h", &Row::operating_hours},
    {"tonnes", "t", &Row::tonnes},
    {"lifter_height_m", "m", &Row::lifter_height},
    {"face_angle_deg", "degree", Degrees{&Row::face_angle}},
    {"plate_thickness_m", "m", &Row::plate_thickness},
    {"worn_volume_m3_per_m", "m3/m", &Row::worn_volume},
    {"worn_fraction", "1", &Row::worn_fraction},
    {"power_w", "W", &Row::power},
    {"shoulder_deg", "degree", Degrees{&Row::shoulder}},
    {"toe_deg", "degree", Degrees{&Row::toe}},
    {"power_w_se", "W", &Row::power_error},
    {"shoulder_deg_se", "degree", Degrees{&Row::shoulder_error}},
    {"toe_deg_se", "degree", Degrees{&Row::toe_error}},
    {"lifter_height_m_se", "m", &Row::lifter_height_error},
    {"plate_thickness_m_se", "m", &Row::plate_thickness_error},
    {"worn_volume_m3_per_m_se", "m3/m", &Row::worn_volume_error},
    {"airborne_share", "1", &Row::airborne_share},
    {"airborne_share_se", "1", &Row::airborne_share_error},
    {"bare_hit_power_w", "W", &Row::bare_hit_power},
    {"bare_hit_power_w_se", "W", &Row::bare_hit_power_error},
    {"dead_zone_share", "1", &Row::dead_zone_share},
    {"dead_zone_share_se", "1", &Row::dead_zone_share_error},
    {"between_lifters_locked_share", "1", &Row::between_locked_share},
    {"between_lifters_locked_share_se", "1", &Row::between_locked_share_error},
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
