#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

using Curve = std::vector<Eigen::Vector2d>;

/// A rotation about the origin, then a shift:  p -> R(angle) p + shift.
struct RigidMotion {
  double angle;           ///< [rad]
  Eigen::Vector2d shift;  ///< [m]

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& point) const;
};

/// A curve in the frame of the master lifter, from its trailing side to its leading one.
struct AlignedCurve {
  Curve nodes;         ///< (xi, eta) [m]
  RigidMotion motion;  ///< from the frame it came in
  bool reversed;       ///< its nodes came in the opposite order
};

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

/// The curve as seen from the other end of the mill: x changes sign.
[[nodiscard]] Curve mirror_image(const Curve& curve);

/// A curve that lies in the master frame already: only its order may change.
[[nodiscard]] AlignedCurve kept_in_place(const LinerSector& sector, const Curve& curve);

/// Puts the two ends of the curve symmetrically on the circle of `end_radius` [m] about the mill's
/// axis: at the sector's edges where they are as far apart as these, within three standard errors
/// of their distance and a millimetre; else, where they are closer, on the plate before and behind
/// the lifter, whose arc is added up to the edges. The order of the nodes and which way is up are
/// those in which the curve lies nearer to `reference`. The place of the plate is not in the curve:
/// `end_radius` says it. `error` is the standard error of a length [m]. Throws InputError for fewer
/// than three nodes, and for ends that coincide or are farther apart than the edges.
[[nodiscard]] AlignedCurve aligned_by_ends(const LinerProfile& reference, const Curve& curve,
                                           double end_radius, double error);

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
