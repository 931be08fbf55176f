#include "orchestrator/study/liner_impacts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <ranges>

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct OfEnergy {
  double hits_per_second = 0.0;
  double power = 0.0;
};

}  // namespace

LinerImpacts liner_impacts(const std::vector<SpectrumRow>& rows) {
  std::map<double, OfEnergy> classes;  // by their lower limit
  for (const SpectrumRow& row : rows) {
    if (row.cycle != 0 || row.contact != CollisionWith::liner ||
        row.direction != EnergyDirection::normal)
      continue;
    OfEnergy& of_energy = classes[row.energy_low];
    of_energy.hits_per_second += row.events_per_second;
    of_energy.power += row.power;
  }
  LinerImpacts impacts{nan, nan, {}};
  if (classes.empty()) return impacts;
  impacts.power = 0.0;
  for (const auto& [energy, of_energy] : classes) impacts.power += of_energy.power;
  OfEnergy above;
  for (const auto& [energy, of_energy] : std::views::reverse(classes)) {
    above.hits_per_second += of_energy.hits_per_second;
    if (above.power < 0.5 * impacts.power) impacts.half_energy = energy;
    above.power += of_energy.power;
    impacts.exceeded.push_back({energy, above.hits_per_second});
  }
  std::ranges::reverse(impacts.exceeded);
  return impacts;
}

}  // namespace millwear::orchestrator
