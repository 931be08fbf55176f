#include "wear/rate/smoothing_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/failure.h"
#include "wear/numerics/random_stream.h"

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double least_peak = 0.5;

}  // namespace

Eigen::VectorXd standard_error(const SmoothedLoss& loss) {
  if (loss.block_modes.cols() < 2)
    return Eigen::VectorXd::Constant(loss.rate.values.size(), unknown);
  const Eigen::VectorXd variance =
      loss.block_modes.rowwise().squaredNorm() + loss.bias_modes.rowwise().squaredNorm();
  return loss.path.array() * variance.array().sqrt();
}

double peak_error(const SmoothedLoss& loss) {
  const auto& rate = loss.per_path;
  const Eigen::Index bins = rate.size();
  const double greatest = rate.maxCoeff();
  if (loss.block_modes.cols() < 2 || !(greatest > 0.0)) return unknown;
  const Eigen::VectorXd error = loss.block_modes.rowwise().norm();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double neighbours = std::max(rate[(i + bins - 1) % bins], rate[(i + 1) % bins]);
    if (rate[i] >= neighbours && rate[i] > least_peak * greatest)
      largest = std::max(largest, error[i] / rate[i]);
  }
  return largest;
}

Eigen::MatrixXd rate_replicates(const SmoothedLoss& loss, Eigen::Index count, std::uint64_t seed,
                                ReplicateOf what) {
  const Eigen::Index blocks = loss.block_modes.cols();
  const Eigen::Index modes = loss.bias_modes.cols();
  if (blocks < 2) throw InputError("a load of one time block has no replicates; take two or more");
  const Eigen::Index freedom = blocks - 1;
  const Eigen::MatrixXd normals = standard_normals(blocks + freedom + modes, count, seed);
  const Eigen::RowVectorXd stretch =
      (static_cast<double>(freedom) /
       normals.middleRows(blocks, freedom).colwise().squaredNorm().array())
          .sqrt();
  Eigen::MatrixXd deviations = loss.block_modes * normals.topRows(blocks) * stretch.asDiagonal();
  if (what == ReplicateOf::noise_and_bias)
    deviations += loss.bias_modes * normals.bottomRows(modes);
  return deviations;
}

}  // namespace millwear::wear
