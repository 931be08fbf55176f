#include "orchestrator/results/motion_of_cycle.h"

namespace millwear::orchestrator {

MotionOfCycle motion_of_cycle(int cycle, const Measured& measured,
                              const wear::LinerRecord& record) {
  MotionOfCycle shown{cycle, measured.motion, {}};
  if (!record.motion) return shown;
  const Eigen::VectorXd energy =
      (record.motion->plate.energy + record.motion->lifter.energy).rowwise().sum();
  for (Eigen::Index first = 0; first < energy.size(); first += hit_arc_degrees)
    shown.hit_power.push_back(energy.segment(first, hit_arc_degrees).sum() /
                              (record.load.duration * hit_arc_degrees));
  return shown;
}

}  // namespace millwear::orchestrator
