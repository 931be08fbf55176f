#pragma once
#include <vector>

#include "liggghts_inputs/decks/charge_data.h"
#include "mill/case/case.h"

namespace millwear::liggghts {

/// Places every particle of the charge at random inside the liner (at mill angle 0), largest
/// classes first, none touching another (y is periodic) or the liner, as low as a loose packing
/// allows, under a surface that leans as that of a charge in motion. The same seed gives the same
/// packing on every machine and for any number of ranks, and the count is exactly what was asked:
/// LIGGGHTS's own insertion can fall short with only a warning. Throws InputError where the charge
/// is too much to be placed apart (above roughly 38 % solid).
[[nodiscard]] std::vector<PlacedParticle> pack_charge(const Case& mill);

}  // namespace millwear::liggghts
