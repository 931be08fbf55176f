#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/csv_columns.h"

namespace millwear::orchestrator {

enum class CollisionWith { liner, particles };
enum class EnergyDirection { normal, shear };

/// How often collisions dissipate an energy between two limits, normal to the contact or along it.
struct SpectrumRow {
  int cycle;
  CollisionWith contact;
  std::string class_a;  ///< particle class
  std::string class_b;  ///< the other particle's; empty for the liner
  EnergyDirection direction;
  double energy_low;         ///< [J]; the lowest class of all takes in what lies below, too
  double energy_high;        ///< [J]; the highest what lies above
  double events_per_second;  ///< collisions in the simulated slice [1/s]
  double power;              ///< that they dissipate in this direction [W]
};

/// The columns of `spectra.csv`.
[[nodiscard]] std::span<const CsvColumn<SpectrumRow>> spectrum_columns();

/// Lines of `spectra.csv`, and its first two.
[[nodiscard]] std::string spectrum_lines(const std::vector<SpectrumRow>& rows);
[[nodiscard]] std::string spectra_head();

/// The bytes of `spectra.csv`; the same rows always give the same bytes.
[[nodiscard]] std::string spectra_csv(const std::vector<SpectrumRow>& rows);

/// Reads `spectra.csv` back. Throws DiskError or ResultRejected (file:line).
[[nodiscard]] std::vector<SpectrumRow> read_spectra_csv(const std::filesystem::path& path);

}  // namespace millwear::orchestrator
