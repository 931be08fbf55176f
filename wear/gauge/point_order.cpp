#include "wear/gauge/point_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wear/gauge/scan_thinning.h"

namespace millwear::wear {
namespace {

using Curve = std::vector<Eigen::Vector2d>;

constexpr double sharpest_turn = 150.0 * std::numbers::pi / 180.0;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether the segments from `i` and from `j` cross between their ends.
bool cross_each_other(const Curve& curve, std::size_t i, std::size_t j) {
  const Eigen::Vector2d along = curve[i + 1] - curve[i];
  const Eigen::Vector2d other = curve[j + 1] - curve[j];
  return cross(along, curve[j] - curve[i]) * cross(along, curve[j + 1] - curve[i]) < 0.0 &&
         cross(other, curve[i] - curve[j]) * cross(other, curve[i + 1] - curve[j]) < 0.0;
}

bool turns_back(const Curve& curve, std::size_t at, double least) {
  const Eigen::Vector2d in = curve[at] - curve[at - 1];
  const Eigen::Vector2d out = curve[at + 1] - curve[at];
  return std::min(in.norm(), out.norm()) > least &&
         in.dot(out) < std::cos(sharpest_turn) * in.norm() * out.norm();
}

double extent_between(const Curve& curve, std::size_t first, std::size_t last) {
  const auto from = curve.begin() + static_cast<std::ptrdiff_t>(first);
  return extent_of({from, curve.begin() + static_cast<std::ptrdiff_t>(last) + 1});
}

}  // namespace

std::optional<Disorder> first_disorder(const Curve& curve, double least) {
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    for (std::size_t j = i + 2; j + 1 < curve.size(); ++j)
      if (cross_each_other(curve, i, j) && extent_between(curve, i + 1, j) > least)
        return Disorder{i + 1, j};
    if (i > 0 && turns_back(curve, i, least)) return Disorder{i, i + 1};
  }
  return std::nullopt;
}

}  // namespace millwear::wear
