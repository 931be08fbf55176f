#pragma once
#include <optional>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Cuts the ranks' columns along x so that each has equally many particles, and moves the particles
/// to the ranks that have them then. Between two runs, by every rank; does nothing for no columns.
/// Throws InputError where the deck's `processors` makes other columns.
void balance_columns(LAMMPS_NS::LAMMPS& liggghts, std::optional<long> columns);

}  // namespace millwear::recorder
