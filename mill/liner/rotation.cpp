#include "mill/liner/rotation.h"

#include <algorithm>

namespace millwear {
namespace {

constexpr double same_time = 1.0;  // [s]

}  // namespace

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

LinerProfile as_turned(const LinerProfile& liner, Rotation rotation) {
  return rotation == Rotation::as_new ? liner : mirrored(liner);
}

}  // namespace millwear
