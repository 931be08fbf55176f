#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace millwear::wear {

/// Points of a curve that are not in their order along it, by their indices.
struct Disorder {
  std::size_t first;
  std::size_t last;
};

/// The first points that are out of order: a loop in which the curve crosses itself, or a place
/// where it turns back by more than 150 degrees, wider than `least` [m]. Noise makes smaller ones.
/// None where the curve is in order.
[[nodiscard]] std::optional<Disorder> first_disorder(const std::vector<Eigen::Vector2d>& curve,
                                                     double least);

}  // namespace millwear::wear
