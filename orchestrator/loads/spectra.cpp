#include "orchestrator/loads/spectra.h"

#include <array>
#include <string_view>

namespace millwear::orchestrator {
namespace {

using Row = SpectrumRow;

constexpr std::string_view spectra_format = "millwear spectra 1";
constexpr std::array<std::string_view, 2> contact_names{"liner", "particles"};
constexpr std::array<std::string_view, 2> direction_names{"normal", "shear"};
constexpr std::array<CsvColumn<Row>, 9> columns{{
    {"cycle", "1", "DEM load, from 0", "", &Row::cycle},
    {"contact", "", "`liner`: of a particle with the liner; `particles`: of two particles", "",
     InWords<Row>{
         contact_names, [](const Row& row) { return static_cast<std::size_t>(row.contact); },
         [](Row& row, std::size_t value) { row.contact = static_cast<CollisionWith>(value); }}},
    {"class_a", "", "particle class: material and diameter, like `steel_30mm`", "", &Row::class_a},
    {"class_b", "",
     "the other particle's; empty for the liner. Every pair stands once, in the order of the "
     "classes",
     "", &Row::class_b},
    {"direction", "", "`normal` or `shear`", "",
     InWords<Row>{
         direction_names, [](const Row& row) { return static_cast<std::size_t>(row.direction); },
         [](Row& row, std::size_t value) { row.direction = static_cast<EnergyDirection>(value); }}},
    {"energy_low_j", "J", "lower limit of the class; the lowest, 1e-9, takes in all below", "",
     &Row::energy_low},
    {"energy_high_j", "J", "upper limit of the class; the highest, 1e5, takes in all above", "",
     &Row::energy_high},
    {"events_per_second", "1/s", "collisions", "", &Row::events_per_second},
    {"power_w", "W", "that they dissipate in this direction", "", &Row::power},
}};

}  // namespace

std::span<const CsvColumn<SpectrumRow>> spectrum_columns() { return columns; }

std::string spectra_head() { return csv_head({spectra_format, names_of(spectrum_columns())}); }

std::string spectrum_lines(const std::vector<SpectrumRow>& rows) {
  return csv_lines(spectrum_columns(), rows);
}

std::string spectra_csv(const std::vector<SpectrumRow>& rows) {
  return csv_table(spectra_format, spectrum_columns(), rows);
}

std::vector<SpectrumRow> read_spectra_csv(const std::filesystem::path& path) {
  return read_csv_table(path, spectra_format, spectrum_columns());
}

}  // namespace millwear::orchestrator
