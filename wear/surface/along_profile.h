#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// The segment that an arc length of a profile lies on, 0 ... length [m]; `lengths` are the
/// profile's `arc_lengths`.
[[nodiscard]] std::size_t segment_at(const std::vector<double>& lengths, double arc_length);

/// An arc length modulo that of the pitch [m].
[[nodiscard]] double on_one_pitch(double arc_length, double length);

/// The place of a profile at an arc length [m], taken modulo the length of the pitch.
[[nodiscard]] Eigen::Vector2d place_at(const LinerProfile& profile,
                                       const std::vector<double>& lengths, double arc_length);

/// The angle from one direction to another [rad], -pi ... pi; > 0 against the clock, so < 0 on a
/// crest of a profile that is walked along.
[[nodiscard]] double turn_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace millwear::wear
