#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Has meshes that turn (`fix move/mesh ... rotate`) turned by `turned_vectors.h`, several vectors
/// at once. All that LIGGGHTS keeps of a mesh gets the bits that its own rotation would give. Other
/// motions, two motions of one mesh, and meshes of other kinds it moves itself. To be called before
/// the first line of a deck.
void turn_meshes_by_vectors(LAMMPS_NS::LAMMPS& liggghts);

}  // namespace millwear::recorder
