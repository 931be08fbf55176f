#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// Indices of the first pair of segments that cross (over the pitch and its two neighbours), or
/// {-1, -1} where the profile is simple.
[[nodiscard]] std::pair<int, int> first_crossing(const LinerProfile& profile);

/// Indices of two nodes of the segments of a `crossing` that are the same point (`same_point`): the
/// profile does not cross itself but comes to a node twice. None where it does cross itself.
[[nodiscard]] std::optional<std::pair<int, int>> node_given_twice(const LinerProfile& profile,
                                                                  std::pair<int, int> crossing);

/// Index of the second of two neighbouring nodes that are equal; none where all differ.
[[nodiscard]] std::optional<std::size_t> first_repeated_node(
    const std::vector<Eigen::Vector2d>& nodes);

}  // namespace millwear
