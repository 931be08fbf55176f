#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Two particles in contact in one step, with the force LIGGGHTS applied.
struct PairTouch {
  int first, second;     ///< LIGGGHTS's indices of them on this rank, in this step
  double normal_power;   ///< Fn v_n [W]
  double shear_power;    ///< -Ft . v_slip [W]
  double rolling_power;  ///< of the rolling torque on the relative spin [W]
};

/// Has LIGGGHTS keep the force of every contact between particles, from the next run on. Throws
/// InputError for a deck without a granular pair style.
void keep_pair_forces(LAMMPS_NS::LAMMPS& liggghts);

/// Every contact between particles of this rank, at the end of a step, each once over all ranks: by
/// the rank that owns the particle of the smaller number. All ranks have to call it together: the
/// velocities of the neighbours' particles are brought up to the end of the step first, which
/// LIGGGHTS itself does at the start of the next.
void for_each_pair(LAMMPS_NS::LAMMPS& liggghts, const std::function<void(const PairTouch&)>& take);

}  // namespace millwear::recorder
