#pragma once
#include <cstdint>
#include <vector>

#include "mill/case/case.h"
#include "mill/load/wall_contacts.h"
#include "mill/recording/recorder_orders.h"
#include "recorder/record/wall_module.h"
#include "wear/record/charge_motion.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Steps between two censuses: a multiple of the samples' interval, fifty to the pitch, and four at
/// least to a time block. `time_step` in s.
[[nodiscard]] long census_steps(const Case& mill, const RecordingPlan& plan, double time_step);

/// Masses of the parts of this rank's charge at the end of a step, when forces and velocities are
/// of the same instant. A particle is airborne where the force on it is its weight, to a millionth
/// of that.
[[nodiscard]] wear::Census census_of(LAMMPS_NS::LAMMPS& liggghts, const wear::TurningMill& mill);

/// Tells of fast touches whether the particle touches anything but the wall.
class CompanyFinder {
 public:
  /// For each touch of a step, at its end. Unknown where the centre came towards the wall at less
  /// than `wear::bare_hit_speed`: of these nobody asks. All of a particle's touches together make
  /// the wall's force on it; with its weight that is all the force where it has no other company.
  const std::vector<Company>& of(LAMMPS_NS::LAMMPS& liggghts,
                                 const std::vector<WallTouch>& touches);

 private:
  void find_fast(const std::vector<WallTouch>& touches);

  std::vector<Company> company_;
  std::vector<std::uint32_t> slot_of_particle_;  ///< in `wall_force_`, + 1; 0 for none
  std::vector<int> fast_;                        ///< particles
  std::vector<Eigen::Vector3d> wall_force_;      ///< on them [N]
};

}  // namespace millwear::recorder
