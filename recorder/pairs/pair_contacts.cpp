#include "recorder/pairs/pair_contacts.h"

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/fix_contact_property_atom.h>
#include <liggghts/force.h>
#include <liggghts/lammps.h>
#include <liggghts/pair_gran.h>

#include <Eigen/Geometry>
#include <cmath>

#include "mill/base/failure.h"
#include "recorder/liggghts/atom_values.h"

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;
using LAMMPS_NS::LAMMPS;

LAMMPS_NS::PairGran& granular_pair(LAMMPS& liggghts) {
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(liggghts.force->pair_match("gran", 0));
  if (pair == nullptr) throw InputError("the deck has no `pair_style gran`");
  return *pair;
}

/// Powers of one contact; `history` holds force and torque on the first particle.
PairTouch powers_of(const LAMMPS& liggghts, int i, int j, const double* history) {
  const auto& atom = *liggghts.atom;
  Vector3d apart = at(atom.x, j) - at(atom.x, i);
  liggghts.domain->minimum_image(apart.x(), apart.y(), apart.z());
  const double distance = apart.norm();
  const Vector3d normal = apart / distance;
  const double overlap = atom.radius[i] + atom.radius[j] - distance;
  const double arm_i = atom.radius[i] - 0.5 * overlap;
  const double arm_j = atom.radius[j] - 0.5 * overlap;

  const Vector3d force(history[0], history[1], history[2]);
  const Vector3d torque(history[3], history[4], history[5]);
  const Vector3d tangential = force - force.dot(normal) * normal;
  const Vector3d centres = at(atom.v, i) - at(atom.v, j);
  const Vector3d spin_i = at(atom.omega, i);
  const Vector3d spin_j = at(atom.omega, j);
  const double closing = centres.dot(normal);
  const Vector3d slip =
      centres - closing * normal + (arm_i * spin_i + arm_j * spin_j).cross(normal);
  const Vector3d rolling_torque = torque - arm_i * normal.cross(tangential);
  return {i, j, -force.dot(normal) * closing, -tangential.dot(slip),
          -rolling_torque.dot(spin_i - spin_j)};
}

}  // namespace

void keep_pair_forces(LAMMPS& liggghts) { granular_pair(liggghts).do_store_contact_forces(); }

void for_each_pair(LAMMPS& liggghts, const std::function<void(const PairTouch&)>& take) {
  auto* const forces = granular_pair(liggghts).fix_contact_forces();
  if (forces == nullptr)
    throw InputError(
        "no `run` of the deck begins where the collisions between particles are to be recorded");
  liggghts.comm->forward_comm();
  auto& atom = *liggghts.atom;
  for (int i = 0; i < atom.nlocal; ++i)
    for (int k = 0; k < forces->n_partner(i); ++k) {
      const int partner = forces->partner(i, k);
      if (partner <= atom.tag[i]) continue;
      const int j = atom.map(partner);
      if (j < 0) throw ResultRejected("a particle touches one that its rank does not know of");
      take(powers_of(liggghts, i, j, forces->contacthistory(i, k)));
    }
}

}  // namespace millwear::recorder
