#include "orchestrator/gauge/gauge_folder.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "wear/gauge/profile_comparison.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr double errors_apart = 3.0;
constexpr double casting_tolerance = 1e-3;

}  // namespace

fs::path gauge_folder(const Case& mill, const std::optional<fs::path>& named) {
  return named.value_or(mill.file.parent_path() / "gauge");
}

void check_under_new_liner(const GaugeReading& reading, const LinerProfile& liner,
                           const std::string& place) {
  const double allowed = errors_apart * reading.error + casting_tolerance;
  const auto check = [&](double excess, std::string_view what) {
    if (excess > allowed)
      throw InputError(
          fmt::format("{}: {} lies {:.1f} mm above the new liner of the case ({:.1f} mm at most, "
                      "three errors and a millimetre for the casting); is it another mill's, in "
                      "another unit, or not aligned?",
                      place, what, 1e3 * excess, 1e3 * allowed));
  };
  if (reading.lifter_height) check(*reading.lifter_height - lifter_height(liner), "the lifter");
  if (reading.plate_thickness)
    check(*reading.plate_thickness - plate_thickness(liner), "the plate's surface");
  if (reading.profile) check(wear::highest_above(*reading.profile, liner), "the profile");
}

std::vector<GaugeReading> readings_in(const fs::path& folder, const Case& mill) {
  const fs::path table = folder / gauge_table_name;
  if (!fs::exists(table)) return {};
  const auto rows = read_gauge_rows(table);
  auto readings = gauge_readings(rows, table, mill.liner.sector);
  for (std::size_t i = 0; i < readings.size(); ++i)
    check_under_new_liner(readings[i], mill.liner,
                          fmt::format("{}:{}", table.string(), rows[i].line));
  return readings;
}

std::vector<GaugeReading> needed_readings_in(const fs::path& folder, const Case& mill) {
  auto readings = readings_in(folder, mill);
  if (readings.empty())
    throw InputError(
        fmt::format("{}: no gauge reading is here; bring one with `millwear import {} FILE "
                    "--hours H`, or name its folder with --readings",
                    (folder / gauge_table_name).string(), mill.file.string()));
  return readings;
}

void add_readings(const std::vector<GaugeReading>& readings, CampaignResults& data) {
  for (const GaugeReading& reading : readings) {
    if (reading.lifter_height)
      data.measured.push_back({reading.operating_hours, *reading.lifter_height, reading.error});
    if (reading.profile)
      data.measured_profiles.push_back({reading.operating_hours, reading.profile->nodes});
  }
}

}  // namespace millwear::orchestrator
