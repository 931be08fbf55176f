#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Has LIGGGHTS compute the forces between particles in a loop of ours, which evaluates
/// a contact only where two particles touch, several at once (`hertz_contacts.h`). It takes the
/// place of LIGGGHTS's loop for Hertz with tangential history and `cdt` or `epsd2`. The contacts
/// are the same in the same order, so particles move by the same bits. With any other model, with
/// options of a model, and in a step of which more is asked than forces (a virial, a pair compute),
/// LIGGGHTS does as before. To be called before the first line of a deck.
void compute_only_touching_pairs(LAMMPS_NS::LAMMPS& liggghts);

}  // namespace millwear::recorder
