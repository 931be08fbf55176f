#include "recorder/neighbours/neighbours_by_size.h"

#include <liggghts/lammps.h>

#include "recorder/liggghts/fix_makers.h"
#include "recorder/neighbours/particle_neighbours.h"
#include "recorder/neighbours/wall_neighbours.h"

namespace millwear::recorder {

void find_neighbours_by_size(LAMMPS_NS::LAMMPS& liggghts) {
  delete liggghts.neighbor;
  liggghts.neighbor = new ParticleNeighbours(&liggghts);
  make_fixes_by(liggghts, "neighlist/mesh", new_wall_neighbours);
}

}  // namespace millwear::recorder
