#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "mill/liner/profile_measures.h"

namespace millwear {

/// What a gauge or a scan told of the liner at one date.
struct GaugeReading {
  double operating_hours;                 ///< since the liner was new [h], >= 0
  std::optional<double> lifter_height;    ///< [m], as lifter_height() defines it
  std::optional<double> plate_thickness;  ///< [m], as plate_thickness() defines it
  std::optional<LinerProfile> profile;    ///< aligned to the master lifter
  double error;                           ///< standard error of all its lengths [m], > 0
};

/// The name of the table in a folder of readings.
inline constexpr const char* gauge_table_name = "gauge_readings.csv";

/// A row of the table as it stands there.
struct GaugeRow {
  double operating_hours;               ///< [h]
  std::optional<double> lifter_height;  ///< [m]; where empty and there is a profile: the profile's
  std::optional<double> plate_thickness;  ///< [m]; likewise
  std::string profile_csv;                ///< named from the table's folder; empty for none
  double error;                           ///< [m]
  int line = 0;                           ///< in the file, from 1
};

/// The rows of a table of gauge readings, in increasing order of time: first line
/// `# millwear gauge readings 1`, second the names of the columns, `operating_hours,
/// lifter_height_m,plate_thickness_m,profile_csv,error_m` (docs/file_formats.md).
/// Throws InputError (file:line) where it is not, or a row says nothing or what cannot be.
[[nodiscard]] std::vector<GaugeRow> read_gauge_rows(const std::filesystem::path& table);

/// The bytes of the table.
[[nodiscard]] std::string gauge_readings_csv(const std::vector<GaugeRow>& rows);

/// The readings of the rows, whose profiles are read from `table`'s folder. A reading with a
/// profile has a lifter height and a plate thickness too: the row's, or else the profile's.
/// Throws InputError (file:line) for a profile that cannot be read, crosses itself or reaches below
/// the shell, for a height above the mill's axis, and where steel grows: a lifter height, a plate
/// thickness or a steel area larger than that of an earlier reading by more than three standard
/// errors of their difference (that of an area: `error` times the length of the profile).
[[nodiscard]] std::vector<GaugeReading> gauge_readings(const std::vector<GaugeRow>& rows,
                                                       const std::filesystem::path& table,
                                                       const LinerSector& sector);

/// Steel only goes: throws InputError ("PLACE: what") where a reading, in increasing order of time,
/// tells of more than an earlier one. `places` says where each was read.
void check_steel_goes(const std::vector<GaugeReading>& readings,
                      const std::vector<std::string>& places);

/// `gauge_readings` of `read_gauge_rows`.
[[nodiscard]] std::vector<GaugeReading> read_gauge_readings(const std::filesystem::path& table,
                                                            const LinerSector& sector);

}  // namespace millwear
