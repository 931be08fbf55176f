#include "recorder/neighbours/neighbours_by_size.h"

#include <liggghts/lammps.h>
#include <liggghts/modify.h>

#include <map>
#include <string>

#include "recorder/liggghts/private_member.h"
#include "recorder/neighbours/particle_neighbours.h"
#include "recorder/neighbours/wall_neighbours.h"

namespace millwear::recorder {

// LIGGGHTS makes the fix of a wall's neighbours by its style's name, from a private table.
struct FixMakers {
  using Make = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
  using Type = std::map<std::string, Make>* LAMMPS_NS::Modify::*;
  friend Type member(FixMakers);
};
template struct Reach<FixMakers, &LAMMPS_NS::Modify::fix_map>;

void find_neighbours_by_size(LAMMPS_NS::LAMMPS& liggghts) {
  delete liggghts.neighbor;
  liggghts.neighbor = new ParticleNeighbours(&liggghts);
  auto& makers = *(liggghts.modify->*member(FixMakers{}));
  makers["neighlist/mesh"] = new_wall_neighbours;
}

}  // namespace millwear::recorder
