#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Has LIGGGHTS look only at the particles that may touch a triangle (`triangle_reach.h`) where it
/// computes the forces of meshes on particles. Its own loop looks at all within the skin of the
/// neighbour lists, five times as many. The contacts are the same in the same order. To be called
/// before the first line of a deck.
void look_only_near_walls(LAMMPS_NS::LAMMPS& liggghts);

}  // namespace millwear::recorder
