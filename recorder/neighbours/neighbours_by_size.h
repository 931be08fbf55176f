#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Makes LIGGGHTS find the neighbours of its particles and of its moving walls by `SizeGrids`. Its
/// own searches look, for every particle and triangle, through all that lies within the reach of
/// the largest particle. What touches is the same in the same order, so particles move by the same
/// bits. Only the count of triangles near a particle (`n_neighs_...`) may be larger, see
/// recorder/neighbours/wall_neighbours.h. To be called before the first line of a deck.
void find_neighbours_by_size(LAMMPS_NS::LAMMPS& liggghts);

}  // namespace millwear::recorder
