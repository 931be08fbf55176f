#pragma once
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/loads/spectra.h"
#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// How often collisions of one kind dissipate how much. Rates are per second of the simulated
/// slice.
struct ImpactLine {
  std::string name;  ///< particle class, or pair of materials
  std::vector<double>
      normal;  ///< collisions by energy normal to the contact, an energy class each [1/s]
  std::vector<double> shear;  ///< by energy along the contact [1/s]
  double events_per_second;
  double normal_power;      ///< dissipated in these collisions, normal to the contact [W]
  double shear_power;       ///< along it [W]
  double unfinished_share;  ///< of all collisions, not seen whole and in none of the above [-]
  double impact_speed;      ///< root mean square [m/s]; NaN where it is not known
};

/// The collisions of one cycle.
struct Impacts {
  int cycle;
  std::vector<ImpactLine> liner;      ///< a line a particle class
  std::vector<ImpactLine> particles;  ///< a line a pair of materials; empty where not recorded
};

/// A name for every particle class, its material and diameter, e.g. `steel_30mm`: no two alike, and
/// none with a comma, quote or line break.
[[nodiscard]] std::vector<std::string> class_names(const Case& mill);

/// The rows of one cycle, where anything was counted: its collisions with the liner, and those
/// between particles where they were recorded. Rates are per second of the simulated slice.
[[nodiscard]] std::vector<SpectrumRow> spectrum_rows(int cycle, const wear::LinerRecord& record,
                                                     const std::vector<std::string>& names);

/// The same as rates: with the liner by particle class, between particles by pair of
/// materials.
[[nodiscard]] Impacts impacts_of(int cycle, const wear::LinerRecord& record, const Case& mill);

}  // namespace millwear::orchestrator
