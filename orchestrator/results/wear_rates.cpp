#include "orchestrator/results/wear_rates.h"

#include <fmt/format.h>

#include "mill/base/csv.h"

namespace millwear::orchestrator {
namespace {

constexpr CsvFormat format{
    "millwear wear rates 1",
    "cycle,mechanism,bin,arc_length_m,depth_rate_m_per_s,depth_rate_m_per_s_se,law"};

}  // namespace

std::string wear_rates_csv(const std::vector<WearRateRow>& rows) {
  std::string text = csv_head(format);
  for (const auto& row : rows)
    text += fmt::format("{},{},{},{},{},{},{}\n", row.cycle, row.mechanism, row.bin,
                        csv_number(row.arc_length), csv_number(row.depth_rate),
                        csv_number(row.depth_rate_error), row.law);
  return text;
}

std::vector<WearRateRow> read_wear_rates_csv(const std::filesystem::path& path) {
  std::vector<WearRateRow> rows;
  for (const auto& line : read_csv(path, format)) {
    CsvFields fields(path, line);
    const int cycle = fields.integer();
    const int mechanism = fields.integer();
    const int bin = fields.integer();
    const double arc_length = fields.number();
    const double rate = fields.number();
    const double error = fields.number();
    rows.push_back({cycle, mechanism, line.fields.back(), bin, arc_length, rate, error});
  }
  return rows;
}

}  // namespace millwear::orchestrator
