#pragma once
#include "wear/gauge/profile_alignment.h"

namespace millwear::wear {

/// How well an aligned curve lies on the reference that it was fitted to.
struct FitQuality {
  double rms;         ///< distance of the places that were used from the reference [m]
  double used_share;  ///< of the curve's length, 0 ... 1; the rest is worn, or stands out
  double hold;  ///< how much the distances grow (rms) with a move along the direction in which
                ///< the used places hold the curve least, 0 ... 1
  double standing_out;  ///< share of the curve that lies over three errors above the reference
};

struct FittedCurve {
  AlignedCurve curve;
  FitQuality quality;
};

/// Finds where the curve, worn in part, lies on `reference`: the turn and shift that minimise the
/// sum over 400 places evenly along the curve of rho(h / s), h the height over the reference and
///     rho(u) = u^2 for -3 < u < 10, 9 below, 100 above.
/// What lies deep in the reference's steel is worn and does not pull; what would stand out of it
/// costs far more, so that a worn lifter is not pulled outwards. From some thousand starts (every
/// turn, shifts over the pitch) the best are refined by Gauss-Newton on the nearest places while s
/// shrinks from the size of the lifter to the scatter of the places above the reference, at most
/// `error`, which no wear disturbs. The nodes' order does not matter.
/// Needs unworn parts: where plate and faces went back alike, it may fit further out than it lies.
/// What is worn to less than three `error` cannot be told from the unworn and pulls by that much.
///
/// Throws InputError, saying what would be right, where the fit is poor (less than 30 % of the
/// curve lies on the reference, its scatter is more than 1.5 `error`, or more
/// than 5 % of it stand out of the reference by over three `error`), where it is ambiguous
/// (another place is nearly as good, or the used places let the curve slide: `hold` under 0.05), or
/// where the curve's mirror image fits better. Source of the method: Chetverikov, Stepanov and
/// Krsek (2005), "Robust Euclidean alignment of 3D point sets: the trimmed iterative closest point
/// algorithm", Image and Vision Computing 23, 299; point-to-line distances by Chen and Medioni
/// (1992), 10, 145.
[[nodiscard]] FittedCurve aligned_by_fit(const LinerProfile& reference, const Curve& curve,
                                         double error);

}  // namespace millwear::wear
