#pragma once
#include <vector>

#include "liggghts_inputs/decks/charge_data.h"
#include "mill/case/case.h"

namespace millwear::liggghts {

/// Throws InputError, with all that differs, where the charge of `source` cannot be that of `mill`:
/// another shell or slice, other diameters, materials of other densities. Liner, speed, counts and
/// how particles touch may differ.
void check_same_charge(const Case& mill, const Case& source);

/// Another mill's charge in this one.
struct CarriedCharge {
  std::vector<PlacedParticle> particles;
  std::size_t moved = 0;  ///< because they lay in the steel
  std::size_t added = 0;  ///< beside others of their class, where the case has more
  std::size_t left = 0;   ///< behind, where it has fewer
};

/// The charge of a mill with the same shell and slice as it lies and moves at mill angle 0, put
/// into this one. Particles that would lie in the steel, by more than a fiftieth of their diameter,
/// go to the nearest free place and keep their velocity. All are shifted along the axis by a share
/// of the slice that the seed draws: the same charge to the physics, another to rounding, so that
/// replicates of one charge part. The counts are the case's, exactly: those to be added and to be
/// left behind are drawn by the seed. Throws InputError where the mill is too full, or has a class
/// of which `source` has none.
[[nodiscard]] CarriedCharge carried_charge(const Case& mill, std::vector<PlacedParticle> source);

}  // namespace millwear::liggghts
