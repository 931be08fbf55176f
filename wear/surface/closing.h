#pragma once
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// A stretch of a liner's surface that a ball cannot touch, such as a foot narrower than the ball.
struct Shadow {
  double from;  ///< arc length of the place that the ball touches before it [m], 0 ... length
  double to;    ///< ... and after it, > from; above the length where it is on the next pitch
};

/// A stretch of the closing that is no surface of the liner.
struct Arc {
  double from;  ///< arc length along the closing [m]
  double to;
};

/// What a ball touches as it rolls over a liner: the closing of the steel by a disc.
struct Closing {
  /// The liner with an arc of the ball over every shadow: one pitch, from a touched place on, which
  /// is the liner's first node wherever that is touched.
  LinerProfile surface;
  std::vector<Shadow> shadows;  ///< in the order of `from`
  std::vector<Arc> arcs;        ///< of the ball, in the order of `from`
};

/// How deep a hollow may lie under the ball and still count as touched, as a share of its radius.
inline constexpr double touched_within = 0.01;

/// The closing by a disc of `radius` [m], > 0 (std::logic_error); arcs have facets of at most 10
/// degrees. A liner that the disc touches nowhere is its own closing.
/// Source: ISO 16610-41, morphological profile filters.
[[nodiscard]] Closing closing_of(const LinerProfile& profile, double radius);

}  // namespace millwear::wear
