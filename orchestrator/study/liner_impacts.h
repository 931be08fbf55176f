#pragma once
#include <vector>

#include "orchestrator/loads/spectra.h"

namespace millwear::orchestrator {

/// How often hits on the liner dissipate more than an energy.
struct ExceededEnergy {
  double energy;           ///< [J]
  double hits_per_second;  ///< in the simulated slice [1/s]
};

/// How particles hit the new liner: what collisions dissipate normal to the contact.
struct LinerImpacts {
  double power;        ///< of all hits [W]; NaN where no collision was recorded
  double half_energy;  ///< hits that dissipate more than this make half of the power [J]
  std::vector<ExceededEnergy> exceeded;  ///< from the least energy to the greatest
};

/// Of the first cycle's rows of `spectra.csv`, over all classes.
[[nodiscard]] LinerImpacts liner_impacts(const std::vector<SpectrumRow>& rows);

}  // namespace millwear::orchestrator
