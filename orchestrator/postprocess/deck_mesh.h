#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>

#include "mill/case/case.h"
#include "orchestrator/postprocess/hand_run.h"

namespace millwear::orchestrator {

/// Triangles of the mesh that the deck reads: of `run.mesh`, or without one of the mesh that
/// `millwear mesh` makes of the case's liner. Throws InputError where the file is no ASCII STL or
/// its corners do not lie on that liner, as it stands at `run.angle`.
[[nodiscard]] std::size_t triangles_of_deck(const Case& mill, const HandRun& run);

}  // namespace millwear::orchestrator
