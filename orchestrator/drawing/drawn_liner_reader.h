#pragma once
#include <string>
#include <vector>

#include "mill/liner/drawn_liner.h"

namespace millwear::orchestrator {

/// The profile that a DXF shows (meshgen/drawing/drawing_profile.h), on its plate: with its origin
/// where the drawing has one, else with its two ends on the circle of the new plate, symmetrically
/// to the lifter's centre and the lifter upright. A lifter without plate gets the plate's arc.
/// Throws InputError (the drawing's name, and what would be right).
[[nodiscard]] LinerProfile read_drawn_liner(const DrawnLiner& drawn, const LinerSector& sector);

/// What of a drawing is left out, a line each.
[[nodiscard]] std::vector<std::string> left_out_of(const DrawnLiner& drawn);

}  // namespace millwear::orchestrator
