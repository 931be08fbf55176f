#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace millwear::meshgen {

using Curve = std::vector<Eigen::Vector2d>;

/// Pieces that follow each other end to end.
struct CurveChain {
  Curve nodes;
  std::vector<std::size_t> pieces;  ///< in the order of the chain
  bool is_closed;
  bool ends_at_a_junction;  ///< where more than two pieces meet
};

/// The chains that pieces with at least two nodes make, whose ends lie within `tolerance` of each
/// other, in either sense. A piece that is drawn twice counts once. Where more than two pieces meet
/// all chains end. The ends of a joint are put on its first one.
[[nodiscard]] std::vector<CurveChain> curve_chains(const std::vector<Curve>& pieces,
                                                   double tolerance);

[[nodiscard]] double length_of(const Curve& curve);

}  // namespace millwear::meshgen
