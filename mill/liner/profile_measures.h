#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear {

/// Section of steel over one pitch, between the profile and the shell [m2].
[[nodiscard]] double steel_area(const LinerProfile& profile);

/// Section of the lifter alone [m2]: the steel that stands above the new plate.
[[nodiscard]] double lifter_area(const LinerProfile& profile);

/// Least distance of the profile from the mill's axis [m]: the crest of the lifter.
[[nodiscard]] double crest_radius(const LinerProfile& profile);

/// Height of the lifter [m]: how far its crest stands above where the plate was when new. It only
/// falls, and below 0 the crest is under the new plate. The lift that the charge feels is this plus
/// what the plate has lost.
[[nodiscard]] double lifter_height(const LinerProfile& profile);

/// Least thickness of steel over the shell anywhere on the profile [m].
[[nodiscard]] double plate_thickness(const LinerProfile& profile);

/// Mean inclination of the leading face against the radial direction [rad]: 0 stands upright, pi/2
/// lies flat. The least-squares line through the face between 20 and 80 % of the lifter's height.
[[nodiscard]] double leading_face_angle(const LinerProfile& profile);

}  // namespace millwear
