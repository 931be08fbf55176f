#include "wear/band/life_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/constants.h"

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double quantile(const Eigen::VectorXd& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<Eigen::Index>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// What is left above a limit at every time (rows), of every replicate (columns).
Eigen::VectorXd times_of_zero(const std::vector<double>& times, const Eigen::MatrixXd& left,
                              double last_load) {
  const Eigen::Index end = left.rows() - 1;
  const double speed = mean_speed(times, left, last_load);
  Eigen::VectorXd zero(left.cols());
  for (Eigen::Index r = 0; r < left.cols(); ++r) {
    Eigen::Index i = 1;
    while (i <= end && left(i, r) > 0.0) ++i;
    if (i > end) {
      zero[r] = speed > 0.0 ? times.back() + left(end, r) / speed : unknown;
      continue;
    }
    const double before = left(i - 1, r);
    const double share = before > 0.0 ? before / (before - left(i, r)) : 0.0;
    const auto k = static_cast<std::size_t>(i);
    zero[r] = times[k - 1] + share * (times[k] - times[k - 1]);
  }
  return zero;
}

}  // namespace

double standard_error_of(const Band& band) {
  return (band.high - band.low) / (2.0 * errors_of_95_percent);
}

Band band_of(Eigen::VectorXd replicates) {
  if (replicates.size() < 2 || !replicates.allFinite()) return {unknown, unknown};
  std::sort(replicates.begin(), replicates.end());
  return {quantile(replicates, 0.025), quantile(replicates, 0.975)};
}

double mean_speed(const std::vector<double>& times, const Eigen::MatrixXd& values, double since) {
  const auto from = std::upper_bound(times.begin() + 1, times.end() - 1, since) - 1;
  return (values.row(from - times.begin()).mean() - values.row(values.rows() - 1).mean()) /
         (times.back() - *from);
}

Eigen::VectorXd lives(const std::vector<ReplicatesInTime>& course, double height_limit,
                      double plate_limit, double last_load) {
  if (course.size() < 2) return {};
  std::vector<double> times;
  for (const auto& moment : course) times.push_back(moment.time);
  const auto moments = static_cast<Eigen::Index>(course.size());
  Eigen::MatrixXd height(moments, course.front().heights.size());
  Eigen::MatrixXd plate(moments, course.front().plates.size());
  for (Eigen::Index i = 0; i < moments; ++i) {
    const auto& moment = course[static_cast<std::size_t>(i)];
    height.row(i) = moment.heights.array() - height_limit;
    plate.row(i) = moment.plates.array() - plate_limit;
  }
  const Eigen::VectorXd by_height = times_of_zero(times, height, last_load);
  const Eigen::VectorXd by_plate = times_of_zero(times, plate, last_load);
  return by_height.binaryExpr(by_plate, [](double a, double b) { return std::fmin(a, b); });
}

}  // namespace millwear::wear
