#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// How two profiles of one mill differ; every difference is a minus b.
struct ProfileDifference {
  double lifter_height;    ///< [m]
  double face_angle;       ///< of the leading face against the radial direction [rad]
  double plate_thickness;  ///< [m]
  double signed_area;      ///< section of steel of a less that of b [m2]
  double absolute_area;    ///< section between the curves, whichever stands above [m2]
  double rms_distance;     ///< root mean square of the distance between them [m]
  double hausdorff;        ///< the largest distance of a place of one from the other [m]
};

/// The largest distance is found to this [m]: it may be so much larger than said.
inline constexpr double hausdorff_tolerance = 1e-5;

/// Compares two profiles of the same sector. The distance of a place is that to the nearest place
/// of the other curve (and of its images on the neighbouring pitches); its mean square is taken
/// over 2000 places evenly spaced along a, likewise along b, and halved:
///     rms^2 = (mean_a d(., b)^2 + mean_b d(., a)^2) / 2.
/// All are exactly 0 for two equal profiles. Throws InputError for profiles of two sectors.
[[nodiscard]] ProfileDifference compare(const LinerProfile& a, const LinerProfile& b);

/// How far the steel of `a` stands out above the surface of `b` at most [m]; 0 where nowhere.
/// Taken at the nodes of `a` and at 2000 places between them.
[[nodiscard]] double highest_above(const LinerProfile& a, const LinerProfile& b);

}  // namespace millwear::wear
