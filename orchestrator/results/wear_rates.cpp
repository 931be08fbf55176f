#include "orchestrator/results/wear_rates.h"

#include <array>

namespace millwear::orchestrator {
namespace {

using Row = WearRateRow;

constexpr std::string_view wear_rates_format = "millwear wear rates 1";
constexpr std::array<CsvColumn<Row>, 7> columns{{
    {"cycle", "1", "DEM load, from 0", "", &Row::cycle},
    {"mechanism", "1", "from 0, in the order of the case's `[[wear.mechanisms]]`", "",
     &Row::mechanism},
    {"bin", "1", "from 0 at the trailing sector edge", "", &Row::bin},
    {"arc_length_m", "m", "of the bin's centre, along the liner that the load was measured on", "",
     &Row::arc_length},
    {"depth_rate_m_per_s", "m/s",
     "steel lost by this mechanism, per second of milling; as sampled, not smoothed, never below 0",
     "", &Row::depth_rate},
    {"depth_rate_m_per_s_se", "m/s", "its standard error; 0 for corrosion", "",
     &Row::depth_rate_error},
    {"law", "", "name of the mechanism's law in the case file", "", &Row::law},
}};

}  // namespace

std::span<const CsvColumn<WearRateRow>> wear_rate_columns() { return columns; }

std::string wear_rates_csv(const std::vector<WearRateRow>& rows) {
  return csv_table(wear_rates_format, wear_rate_columns(), rows);
}

std::vector<WearRateRow> read_wear_rates_csv(const std::filesystem::path& path) {
  return read_csv_table(path, wear_rates_format, wear_rate_columns());
}

}  // namespace millwear::orchestrator
