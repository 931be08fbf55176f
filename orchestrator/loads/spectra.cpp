#include "orchestrator/loads/spectra.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "mill/base/csv.h"

namespace millwear::orchestrator {
namespace {

constexpr CsvFormat format{"millwear spectra 1",
                           "cycle,contact,class_a,class_b,direction,energy_low_j,energy_high_j,"
                           "events_per_second,power_w"};
constexpr std::array<std::string_view, 2> contact_names{"liner", "particles"};
constexpr std::array<std::string_view, 2> direction_names{"normal", "shear"};

}  // namespace

std::string spectra_head() { return csv_head(format); }

std::string spectra_csv(const std::vector<SpectrumRow>& rows) {
  return spectra_head() + spectrum_lines(rows);
}

std::string spectrum_lines(const std::vector<SpectrumRow>& rows) {
  std::string text;
  for (const auto& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", row.cycle,
                        contact_names[static_cast<std::size_t>(row.contact)], row.class_a,
                        row.class_b, direction_names[static_cast<std::size_t>(row.direction)],
                        csv_number(row.energy_low), csv_number(row.energy_high),
                        csv_number(row.events_per_second), csv_number(row.power));
  return text;
}

std::vector<SpectrumRow> read_spectra_csv(const std::filesystem::path& path) {
  std::vector<SpectrumRow> rows;
  for (const auto& line : read_csv(path, format)) {
    CsvFields fields(path, line);
    rows.push_back({.cycle = fields.integer(),
                    .contact = static_cast<CollisionWith>(fields.one_of(contact_names)),
                    .class_a = fields.text(),
                    .class_b = fields.text(),
                    .direction = static_cast<EnergyDirection>(fields.one_of(direction_names)),
                    .energy_low = fields.number(),
                    .energy_high = fields.number(),
                    .events_per_second = fields.number(),
                    .power = fields.number()});
  }
  return rows;
}

}  // namespace millwear::orchestrator
