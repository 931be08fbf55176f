#include "wear/life_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double quantile(const Eigen::VectorXd& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<Eigen::Index>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// When a falling quantity that is known at some times comes to zero.
double time_of_zero(const std::vector<double>& times, const std::vector<double>& left,
                    double last_load) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (left[i] > 0.0) continue;
    const double share = left[i - 1] > 0.0 ? left[i - 1] / (left[i - 1] - left[i]) : 0.0;
    return times[i - 1] + share * (times[i] - times[i - 1]);
  }
  const auto since = std::upper_bound(times.begin() + 1, times.end() - 1, last_load) - 1;
  const auto first = static_cast<std::size_t>(since - times.begin());
  const double speed = (left[first] - left.back()) / (times.back() - times[first]);
  return speed > 0.0 ? times.back() + left.back() / speed : unknown;
}

}  // namespace

Band band_of(Eigen::VectorXd replicates) {
  if (replicates.size() < 2 || !replicates.allFinite()) return {unknown, unknown};
  std::sort(replicates.begin(), replicates.end());
  return {quantile(replicates, 0.025), quantile(replicates, 0.975)};
}

Eigen::VectorXd lives(const std::vector<ReplicatesInTime>& course, double height_limit,
                      double plate_limit, double last_load) {
  if (course.size() < 2) return {};
  std::vector<double> times;
  for (const auto& moment : course) times.push_back(moment.time);
  Eigen::VectorXd life(course.front().heights.size());
  for (Eigen::Index r = 0; r < life.size(); ++r) {
    std::vector<double> height;
    std::vector<double> plate;
    for (const auto& moment : course) {
      height.push_back(moment.heights[r] - height_limit);
      plate.push_back(moment.plates[r] - plate_limit);
    }
    life[r] =
        std::fmin(time_of_zero(times, height, last_load), time_of_zero(times, plate, last_load));
  }
  return life;
}

}  // namespace millwear::wear
