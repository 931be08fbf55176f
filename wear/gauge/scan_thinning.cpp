#include "wear/gauge/scan_thinning.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/failure.h"
#include "wear/numerics/segment_distance.h"

namespace millwear::wear {
namespace {

using Curve = std::vector<Eigen::Vector2d>;

constexpr double most_of_extent = 4.0;
constexpr double parts_of_group = 8.0;
constexpr double errors_a_group = 3.0;
constexpr double raggedness = 1.1;
constexpr double straight_of_error = 0.1;

/// `mean` carried on, away from `next`, as far as `end` lies that way.
Eigen::Vector2d carried_on(const Eigen::Vector2d& mean, const Eigen::Vector2d& next,
                           const Eigen::Vector2d& end) {
  const Eigen::Vector2d away = (mean - next).normalized();
  return mean + std::max(0.0, (end - mean).dot(away)) * away;
}

/// Means of groups of points in turn; a group ends with `most` points, or before the first that
/// lies `reach` or farther from the group's first.
Curve means_of_groups(const Curve& curve, std::size_t most, double reach) {
  Curve means;
  for (std::size_t first = 0; first < curve.size();) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::size_t next = first;
    while (next < curve.size() && next - first < most &&
           (curve[next] - curve[first]).norm() < reach)
      sum += curve[next++];
    means.emplace_back(sum / static_cast<double>(next - first));
    first = next;
  }
  return means;
}

double length_of(const Curve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += (curve[i] - curve[i - 1]).norm();
  return length;
}

bool is_dense(const Curve& curve, double error, std::size_t most) {
  if (curve.size() < 3) return false;
  std::vector<double> steps;
  for (std::size_t i = 1; i < curve.size(); ++i) steps.push_back((curve[i] - curve[i - 1]).norm());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return curve.size() > most || *middle < error;
}

/// The nodes without which the curve would bend otherwise by more than `within` (Douglas, Peucker).
Curve bends_of(const Curve& curve, double within) {
  std::vector<bool> kept(curve.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> stretches = {{0, curve.size() - 1}};
  while (!stretches.empty()) {
    const auto [from, to] = stretches.back();
    stretches.pop_back();
    double worst = within;
    std::size_t bend = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = distance_to_segment(curve[i], curve[from], curve[to]);
      if (off <= worst) continue;
      worst = off;
      bend = i;
    }
    if (bend == from) continue;
    kept[bend] = true;
    stretches.insert(stretches.end(), {{from, bend}, {bend, to}});
  }
  Curve bends;
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (kept[i]) bends.push_back(curve[i]);
  return bends;
}

}  // namespace

double extent_of(const Curve& curve) {
  Eigen::Vector2d low = curve.front();
  Eigen::Vector2d high = low;
  for (const auto& node : curve) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  return (high - low).sum();
}

Curve averaged_scan(const Curve& curve, double spacing) {
  const auto wanted = static_cast<std::size_t>(parts_of_group * extent_of(curve) / spacing) + 1;
  const std::size_t in_part = (curve.size() + wanted - 1) / wanted;
  const Curve parts = means_of_groups(curve, in_part, 2.0 * spacing);
  Curve means = means_of_groups(parts, parts.size(), spacing);
  const bool last_is_a_rest =
      means.size() > 2 && (means.back() - means[means.size() - 2]).norm() < 0.7 * spacing;
  if (last_is_a_rest) means.pop_back();
  if (means.size() < 3)
    throw InputError(
        fmt::format("the curve is too short: all of it lies within {:.3g} mm", 3e3 * spacing));
  if (length_of(means) > most_of_extent * extent_of(curve))
    throw InputError(
        "the points are not in the order of the profile (they run back and forth over it); list "
        "them from one end to the other, or give the error that they have");
  means.front() = carried_on(means.front(), means[1], curve.front());
  means.back() = carried_on(means.back(), means[means.size() - 2], curve.back());
  return means;
}

double group_of_scan(const Curve& curve, double error, std::size_t most) {
  return std::max(errors_a_group * error, 2.0 * extent_of(curve) / static_cast<double>(most));
}

Curve thinned_scan(const Curve& curve, double error, std::size_t most) {
  if (!is_dense(curve, error, most)) return curve;
  Curve averaged = averaged_scan(curve, group_of_scan(curve, error, most));
  if (length_of(curve) > raggedness * length_of(averaged)) return averaged;
  Curve bends = bends_of(curve, straight_of_error * error);
  return bends.size() > most ? averaged : bends;
}

}  // namespace millwear::wear
