#include "wear/surface/roughness.h"

#include "mill/liner/profile_measures.h"
#include "wear/surface/closing.h"

namespace millwear::wear {

double roughness(const LinerProfile& profile, double radius) {
  return (steel_area(closing_of(profile, radius).surface) - steel_area(profile)) /
         arc_lengths(profile).back();
}

}  // namespace millwear::wear
