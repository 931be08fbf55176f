#pragma once
#include <vector>

#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/pictures/composed.h"
#include "orchestrator/pictures/scene.h"

namespace millwear::orchestrator {

/// What the colours of particles tell.
enum class Colouring { speed, size };

/// A colour for every particle class: blue for the first material, brown for the second, the
/// smaller the brighter.
[[nodiscard]] std::vector<ColouredName> class_colours(const std::vector<ShownClass>& classes);

/// The particles of one frame. `fastest` [m/s] is the scale's end.
[[nodiscard]] std::vector<Sphere> spheres_of(const wear::ChargeFrames& frames, std::size_t frame,
                                             Colouring colouring,
                                             const std::vector<ColouredName>& classes,
                                             double fastest);

}  // namespace millwear::orchestrator
