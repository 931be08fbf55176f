#include "wear/numerics/closed_curve.h"

#include <algorithm>
#include <vector>

namespace millwear::wear {

using Eigen::Index;
using Eigen::VectorXd;

Index around(Index step, Index count) { return (step % count + count) % count; }

VectorXd running_mean(const VectorXd& values, Index half_width) {
  const auto count = static_cast<double>(2 * half_width + 1);
  VectorXd means = VectorXd::Zero(values.size());
  for (Index i = 0; i < values.size(); ++i)
    for (Index j = -half_width; j <= half_width; ++j)
      means[i] += values[around(i + j, values.size())] / count;
  return means;
}

double percentile(const VectorXd& values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto rank =
      sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::ranges::nth_element(sorted, rank);
  return *rank;
}

std::optional<double> steps_until_below(const VectorXd& values, double level, Index from,
                                        int direction) {
  for (Index step = 0; step < values.size(); ++step) {
    const double here = values[around(from + direction * step, values.size())];
    const double next = values[around(from + direction * (step + 1), values.size())];
    if (next < level) return static_cast<double>(step) + (here - level) / (here - next);
  }
  return std::nullopt;
}

}  // namespace millwear::wear
