#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace millwear::liggghts {

/// One line of thermo output of our decks.
struct ThermoLine {
  long step;
  std::size_t atoms;
  double kinetic_energy;  ///< [J]
  double spin_energy;     ///< [J]
  double torque;          ///< of the particles on the liner about +y [N m]
};

/// What LIGGGHTS's log tells of a run.
struct RunLog {
  bool complete = false;      ///< the sentinel is there
  std::size_t triangles = 0;  ///< as LIGGGHTS counted them
  std::string error;          ///< its first ERROR line, empty if none
  std::vector<ThermoLine> thermo;
};

/// The thermo line in `line`, and whether it is one.
[[nodiscard]] bool read_thermo_line(std::string_view line, ThermoLine& thermo);

[[nodiscard]] RunLog read_run_log(std::string_view log);

}  // namespace millwear::liggghts
