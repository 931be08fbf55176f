#pragma once
#include <string>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/pictures/charge_spheres.h"

namespace millwear::orchestrator {

/// A charge on its liner at the instant of a frame, and how it is coloured.
struct ChargeAtInstant {
  const wear::ChargeFrames& frames;
  std::size_t frame;
  const LinerProfile& liner;
  Colouring colouring;
  std::vector<ColouredName> classes;
  double fastest;  ///< [m/s], at the end of the scale of speeds
};

/// The mill in section, seen along the axis: the particles as spheres, the liner as steel.
[[nodiscard]] ChargePicture section_picture(const ChargeAtInstant& charge);

/// The same, close to the lifters where the charge rises: the packing between them.
[[nodiscard]] ChargePicture close_up_picture(const ChargeAtInstant& charge);

/// The slice from an angle, with the liner cut open.
[[nodiscard]] ChargePicture slice_picture(const ChargeAtInstant& charge);

}  // namespace millwear::orchestrator
