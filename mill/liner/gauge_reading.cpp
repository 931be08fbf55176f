#include "mill/liner/gauge_reading.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

constexpr std::string_view first_line = "# millwear gauge readings 1";
constexpr std::string_view columns =
    "operating_hours,lifter_height_m,plate_thickness_m,profile_csv,error_m";
constexpr double errors_apart = 3.0;
constexpr std::string_view metres = "metres, such as 0.088";

enum Column : std::size_t { hours, height, plate, profile, error };

void check_head(const UserTable& table, std::string_view text) {
  if (!text.starts_with(first_line) ||
      text.find_first_not_of("\r", first_line.size()) != text.find('\n')) {
    refuse_line(table.file, 1,
                fmt::format("not a table of gauge readings that this version reads; its first line "
                            "is `{}`, its second `{}`",
                            first_line, columns));
  }
  if (fmt::format("{}", fmt::join(table.header.fields, ",")) != columns) {
    refuse_line(table.file, std::max(table.header.line, 2),
                fmt::format("the columns are not as they should be; the line reads `{}`", columns));
  }
}

std::optional<double> length_in(const UserTable& table, const UserRow& row, std::size_t column) {
  if (row.fields[column].empty()) {
    return std::nullopt;
  }
  return number_in(table, row, column, metres);
}

GaugeRow row_of(const UserTable& table, const UserRow& row) {
  const GaugeRow read{number_in(table, row, hours, "hours, such as 5112"),
                      length_in(table, row, height),
                      length_in(table, row, plate),
                      row.fields[profile],
                      number_in(table, row, error, metres),
                      row.line};
  if (read.operating_hours < 0.0) {
    refuse_line(table.file, row.line,
                fmt::format("a reading at {:g} operating hours; the hours count from the new "
                            "liner's 0",
                            read.operating_hours));
  }
  if (!(read.error > 0.0)) {
    refuse_line(table.file, row.line,
                fmt::format("a reading with an error of {:g} m; give the standard error of its "
                            "lengths, such as 0.001",
                            read.error));
  }
  if (!read.lifter_height && !read.plate_thickness && read.profile_csv.empty()) {
    refuse_line(table.file, row.line,
                "the reading says nothing; give a lifter height, a plate thickness or a profile");
  }
  return read;
}

/// A length or an area of a reading, with its standard error.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  double per_unit;
  std::optional<double> value;
  double error;
};

std::vector<Quantity> quantities_of(const GaugeReading& reading) {
  std::optional<double> area;
  double length = 0.0;
  if (reading.profile) {
    area = steel_area(*reading.profile);
    length = arc_lengths(*reading.profile).back();
  }
  return {{"lifter height", "mm", 1e3, reading.lifter_height, reading.error},
          {"plate thickness", "mm", 1e3, reading.plate_thickness, reading.error},
          {"steel area", "cm2", 1e4, area, reading.error * length}};
}

void check_no_growth(const GaugeReading& earlier, const GaugeReading& later,
                     const std::string& place) {
  const auto before = quantities_of(earlier);
  const auto after = quantities_of(later);
  for (std::size_t q = 0; q < after.size(); ++q) {
    if (!before[q].value || !after[q].value) {
      continue;
    }
    const double allowed = errors_apart * std::hypot(before[q].error, after[q].error);
    if (*after[q].value - *before[q].value > allowed) {
      throw InputError(
          fmt::format("{7}: the {0} grows from {1:.4g} {2} at {3:g} h to {4:.4g} {2} at {5:g} h, "
                      "and steel only goes (it may by {6:.3g} {2}, three errors): out of order in "
                      "time, or of another liner? Mend the hours or the reading, or give the error "
                      "that it has",
                      after[q].name, *before[q].value * before[q].per_unit, after[q].unit,
                      earlier.operating_hours, *after[q].value * after[q].per_unit,
                      later.operating_hours, allowed * after[q].per_unit, place));
    }
  }
}

LinerProfile profile_of_row(const GaugeRow& row, const std::filesystem::path& table,
                            const LinerSector& sector) {
  const auto file = table.parent_path() / row.profile_csv;
  LinerProfile read = read_profile_csv(file, sector);
  if (const auto [first, second] = first_crossing(read); first >= 0) {
    refuse_line(file, 1,
                fmt::format("the profile crosses itself (segments {} and {}); mend its nodes",
                            first + 1, second + 1));
  }
  return read;
}

void check_range(const std::filesystem::path& table, const GaugeRow& row,
                 const GaugeReading& reading, const LinerSector& sector) {
  if (reading.lifter_height && (*reading.lifter_height >= sector.plate_radius ||
                                *reading.lifter_height <= -sector.shell_radius)) {
    refuse_line(table, row.line,
                fmt::format("a lifter {:g} m high in a mill of {:g} m radius; the column is in "
                            "metres, from where the plate was when new",
                            *reading.lifter_height, sector.plate_radius));
  }
  if (reading.plate_thickness && *reading.plate_thickness < 0.0) {
    refuse_line(table, row.line,
                fmt::format("steel {:g} mm thick over the shell; it is worn through at 0",
                            1e3 * *reading.plate_thickness));
  }
}

}  // namespace

std::vector<GaugeRow> read_gauge_rows(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  const UserTable table = user_table(text, file);
  check_head(table, text);
  std::vector<GaugeRow> rows;
  for (const UserRow& line : table.rows) {
    const GaugeRow row = row_of(table, line);
    if (!rows.empty() && row.operating_hours <= rows.back().operating_hours) {
      refuse_line(file, row.line,
                  fmt::format("a reading at {:g} h after one at {:g} h; list the readings in "
                              "increasing order of time, one a date",
                              row.operating_hours, rows.back().operating_hours));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string gauge_readings_csv(const std::vector<GaugeRow>& rows) {
  std::string text = fmt::format("{}\n{}\n", first_line, columns);
  const auto field = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string();
  };
  for (const GaugeRow& row : rows) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", row.operating_hours,
                   field(row.lifter_height), field(row.plate_thickness), row.profile_csv,
                   row.error);
  }
  return text;
}

std::vector<GaugeReading> gauge_readings(const std::vector<GaugeRow>& rows,
                                         const std::filesystem::path& table,
                                         const LinerSector& sector) {
  std::vector<GaugeReading> readings;
  for (const GaugeRow& row : rows) {
    GaugeReading reading{
        row.operating_hours, row.lifter_height, row.plate_thickness, {}, row.error};
    if (!row.profile_csv.empty()) {
      reading.profile = profile_of_row(row, table, sector);
      reading.lifter_height = row.lifter_height.value_or(lifter_height(*reading.profile));
      reading.plate_thickness = row.plate_thickness.value_or(plate_thickness(*reading.profile));
    }
    check_range(table, row, reading, sector);
    readings.push_back(std::move(reading));
  }
  std::vector<std::string> places;
  for (const GaugeRow& row : rows) {
    places.push_back(fmt::format("{}:{}", table.string(), row.line));
  }
  check_steel_goes(readings, places);
  return readings;
}

void check_steel_goes(const std::vector<GaugeReading>& readings,
                      const std::vector<std::string>& places) {
  for (std::size_t later = 0; later < readings.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      check_no_growth(readings[earlier], readings[later], places[later]);
    }
  }
}

std::vector<GaugeReading> read_gauge_readings(const std::filesystem::path& table,
                                              const LinerSector& sector) {
  return gauge_readings(read_gauge_rows(table), table, sector);
}

}  // namespace millwear
