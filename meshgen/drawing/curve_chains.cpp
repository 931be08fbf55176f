#include "meshgen/drawing/curve_chains.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace millwear::meshgen {
namespace {

/// Places where pieces end, those within a tolerance as one.
class Joints {
 public:
  explicit Joints(double tolerance) : tolerance_(tolerance) {}

  /// The number of the joint at a place.
  [[nodiscard]] std::size_t at(const Eigen::Vector2d& place) {
    const auto [x, y] = cell_of(place);
    for (long i = x - 1; i <= x + 1; ++i)
      for (long j = y - 1; j <= y + 1; ++j) {
        const auto found = in_cells_.find({i, j});
        if (found == in_cells_.end()) continue;
        for (const std::size_t joint : found->second)
          if ((places_[joint] - place).norm() <= tolerance_) return joint;
      }
    in_cells_[{x, y}].push_back(places_.size());
    places_.push_back(place);
    return places_.size() - 1;
  }

  [[nodiscard]] const Eigen::Vector2d& place(std::size_t joint) const { return places_[joint]; }
  [[nodiscard]] std::size_t count() const { return places_.size(); }

 private:
  using Cell = std::pair<long, long>;

  [[nodiscard]] Cell cell_of(const Eigen::Vector2d& place) const {
    return {std::lround(place.x() / tolerance_), std::lround(place.y() / tolerance_)};
  }

  double tolerance_;
  std::vector<Eigen::Vector2d> places_;
  std::map<Cell, std::vector<std::size_t>> in_cells_;
};

struct Link {
  std::size_t from;
  std::size_t to;
  bool is_used;
};

Eigen::Vector2d middle_of(const Curve& curve) {
  double left = 0.5 * length_of(curve);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double step = (curve[i] - curve[i - 1]).norm();
    if (step >= left && step > 0.0) return curve[i - 1] + left / step * (curve[i] - curve[i - 1]);
    left -= step;
  }
  return curve.back();
}

class Chaining {
 public:
  Chaining(const std::vector<Curve>& pieces, double tolerance)
      : pieces_(pieces), tolerance_(tolerance), joints_(tolerance) {
    for (const Curve& piece : pieces)
      links_.push_back({joints_.at(piece.front()), joints_.at(piece.back()), false});
    at_joint_.resize(joints_.count());
    for (std::size_t i = 0; i < links_.size(); ++i) add(i);
  }

  [[nodiscard]] std::vector<CurveChain> all() {
    std::vector<CurveChain> chains;
    for (std::size_t joint = 0; joint < at_joint_.size(); ++joint)
      if (at_joint_[joint].size() != 2)
        for (const std::size_t link : at_joint_[joint])
          if (!links_[link].is_used) chains.push_back(chain_from(joint, link));
    for (std::size_t link = 0; link < links_.size(); ++link)
      if (!links_[link].is_used) chains.push_back(chain_from(links_[link].from, link));
    return chains;
  }

 private:
  void add(std::size_t index) {
    Link& link = links_[index];
    for (const std::size_t other : at_joint_[link.from]) {
      const bool same_ends = (links_[other].from == link.from && links_[other].to == link.to) ||
                             (links_[other].from == link.to && links_[other].to == link.from);
      if (same_ends &&
          (middle_of(pieces_[other]) - middle_of(pieces_[index])).norm() <= tolerance_) {
        link.is_used = true;
        return;
      }
    }
    at_joint_[link.from].push_back(index);
    at_joint_[link.to].push_back(index);
  }

  CurveChain chain_from(std::size_t joint, std::size_t link) {
    const std::size_t start = joint;
    CurveChain chain{{joints_.place(joint)}, {}, false, at_joint_[joint].size() > 2};
    for (std::optional<std::size_t> next = link; next;) {
      joint = append(*next, joint, chain);
      next = joint == start ? std::nullopt : unused_at(joint);
    }
    chain.is_closed = joint == start;
    chain.ends_at_a_junction = chain.ends_at_a_junction || at_joint_[joint].size() > 2;
    return chain;
  }

  /// Appends a piece that begins at a joint; returns the joint at its other end.
  std::size_t append(std::size_t index, std::size_t joint, CurveChain& chain) {
    Link& link = links_[index];
    link.is_used = true;
    Curve piece = pieces_[index];
    const bool is_backward = link.from != joint;
    if (is_backward) std::reverse(piece.begin(), piece.end());
    const std::size_t end = is_backward ? link.from : link.to;
    piece.back() = joints_.place(end);
    chain.nodes.insert(chain.nodes.end(), piece.begin() + 1, piece.end());
    chain.pieces.push_back(index);
    return end;
  }

  [[nodiscard]] std::optional<std::size_t> unused_at(std::size_t joint) const {
    if (at_joint_[joint].size() != 2) return std::nullopt;
    for (const std::size_t link : at_joint_[joint])
      if (!links_[link].is_used) return link;
    return std::nullopt;
  }

  const std::vector<Curve>& pieces_;
  double tolerance_;
  Joints joints_;
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> at_joint_;
};

}  // namespace

double length_of(const Curve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += (curve[i] - curve[i - 1]).norm();
  return length;
}

std::vector<CurveChain> curve_chains(const std::vector<Curve>& pieces, double tolerance) {
  return Chaining(pieces, tolerance).all();
}

}  // namespace millwear::meshgen
