#pragma once
#include <filesystem>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::orchestrator {

/// One geometry step as it is kept.
struct KeptStep {
  double duration;        ///< [s]
  double removed_area;    ///< from the profiles [m2]
  double accounted_area;  ///< from the bins of the load [m2]
  double fallen_area;     ///< pieces that lost their hold and fell off [m2]
  LinerProfile profile;   ///< after the step
};

/// All steps of one cycle.
struct KeptCycle {
  double smoothing_moved_share;
  double worn_by_load;  ///< rate of loss summed over the bins of the raw load [m2/s]
  std::vector<KeptStep> steps;
};

/// `steps.json`, written into a folder that is published later. Throws DiskError where the file
/// cannot be written, and ResultRejected where it cannot be understood.
void write_cycle(const std::filesystem::path& file, const KeptCycle& cycle);
/// `sector` is where the profiles belong.
[[nodiscard]] KeptCycle read_cycle(const std::filesystem::path& file, const LinerSector& sector);

}  // namespace millwear::orchestrator
