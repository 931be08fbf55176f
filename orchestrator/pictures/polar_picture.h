#pragma once
#include <string>

#include "orchestrator/loads/load_along_profile.h"
#include "wear/record/polar_load.h"

namespace millwear::orchestrator {

/// Where around the turn and where along the profile the liner takes its load, each measure over
/// its mean. As PNG.
[[nodiscard]] std::string polar_picture(const wear::PolarLoad& load, const LoadAlongProfile& along);

}  // namespace millwear::orchestrator
