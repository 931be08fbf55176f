#pragma once
#include "mill/recording/recorder_orders.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Runs a mixing deck in pieces until it is steady (`mixing_state`), at most its whole `run`, and
/// writes how it went from rank 0; every rank has to call it. Eight times in a piece it counts the
/// particles on the liner by class. The pieces belong to one run without
/// setting up anew, so the charge is that of a deck whose `run` was so long from the start.
/// Throws InputError where the deck has not one `run` of the most steps, or averages nothing.
void mix_until_steady(LAMMPS_NS::LAMMPS& liggghts, const MixingOptions& options);

}  // namespace millwear::recorder
