#pragma once
#include "mill/liner/liner_profile.h"

namespace millwear {

/// How far the end of a measured profile may lie from where it belongs [m].
inline constexpr double profile_end_tolerance = 1e-3;

/// A whole pitch from measured nodes [m] that run from the trailing side to the leading one:
/// - what lies beyond a sector edge is cut off there, and a node within `same_point` of the cut
/// with it;
/// - ends on the plate's circle within `tolerance` [m], short of the edges, are put on the
///   circle and joined to the edges by its arc;
/// - ends at the edges with the same radius within `tolerance` are put on the same point of two
///   neighbouring pitches. Ends that already are, to rounding, stay as they are to the bit.
/// Throws InputError if the ends are neither, if nothing stands between ends on the plate, and for
/// fewer than three nodes.
[[nodiscard]] LinerProfile completed_profile(const LinerSector& sector,
                                             std::vector<Eigen::Vector2d> nodes,
                                             double tolerance = profile_end_tolerance);

}  // namespace millwear
