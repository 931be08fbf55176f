#include "mill/liner/rotation.h"

#include <algorithm>

namespace millwear {
namespace {

constexpr double same_time = 1.0;  // [s]

}  // namespace

std::string_view name_of(Rotation rotation) {
  return rotation == Rotation::as_new ? "as_new" : "reversed";
}

int reversals_by(std::span<const double> reversal_times, double time) {
  const auto next =
      std::upper_bound(reversal_times.begin(), reversal_times.end(), time + same_time);
  return static_cast<int>(next - reversal_times.begin());
}

Rotation rotation_after(std::span<const double> reversal_times, double time) {
  return reversals_by(reversal_times, time) % 2 == 0 ? Rotation::as_new : Rotation::reversed;
}

std::optional<double> time_to_reversal(std::span<const double> reversal_times, double time) {
  const auto next = static_cast<std::size_t>(reversals_by(reversal_times, time));
  if (next == reversal_times.size()) return std::nullopt;
  return reversal_times[next] - time;
}

Eigen::Vector2d as_turned(const Eigen::Vector2d& point, Rotation rotation) {
  return rotation == Rotation::as_new ? point : Eigen::Vector2d(-point.x(), point.y());
}

LinerProfile as_turned(const LinerProfile& liner, Rotation rotation) {
  return rotation == Rotation::as_new ? liner : mirrored(liner);
}

std::vector<double> as_turned(const std::vector<double>& at_nodes, Rotation rotation) {
  if (rotation == Rotation::as_new) return at_nodes;
  return {at_nodes.rbegin(), at_nodes.rend()};
}

Eigen::MatrixXd by_bin_as_turned(const Eigen::MatrixXd& by_bin, Rotation rotation) {
  if (rotation == Rotation::as_new) return by_bin;
  return by_bin.colwise().reverse();
}

}  // namespace millwear
