#include "orchestrator/loads/hit_power.h"

namespace millwear::orchestrator {

std::vector<double> hit_power(const wear::LinerRecord& record) {
  std::vector<double> power;
  if (!record.motion) return power;
  const Eigen::VectorXd energy =
      (record.motion->plate.energy + record.motion->lifter.energy).rowwise().sum();
  for (Eigen::Index first = 0; first < energy.size(); first += hit_arc_degrees)
    power.push_back(energy.segment(first, hit_arc_degrees).sum() /
                    (record.load.duration * hit_arc_degrees));
  return power;
}

}  // namespace millwear::orchestrator
