#pragma once

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace millwear::recorder {

/// Makes the fix that keeps which particles are near which triangle of a moving mesh, found by the
/// grids of `ParticleNeighbours`. LIGGGHTS's own looks through all particles within a diameter of
/// the largest around every triangle, and through their periodic copies, which no wall uses.
/// Near is what LIGGGHTS counts as near, a prism around the triangle; where the corner of a sharp
/// triangle's prism stands out of that diameter LIGGGHTS misses particles that touch nothing yet.
/// Standing meshes it leaves to LIGGGHTS.
LAMMPS_NS::Fix* new_wall_neighbours(LAMMPS_NS::LAMMPS* liggghts, int argument_count,
                                    char** arguments);

}  // namespace millwear::recorder
