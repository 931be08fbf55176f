#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Makes LIGGGHTS find the neighbours of its particles and of its moving walls by `SizeGrids`. Its
/// own searches look, for every particle and triangle, through all that lies within the reach of
/// the largest particle. What touches is the same in the same order, so every bit of a run stays
/// what it was. To be called before the first line of a deck.
void find_neighbours_by_size(LAMMPS_NS::LAMMPS& liggghts);

}  // namespace millwear::recorder
