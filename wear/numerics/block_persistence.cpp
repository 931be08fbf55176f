#include "wear/numerics/block_persistence.h"

#include <algorithm>
#include <cmath>

namespace millwear::wear {
namespace {

constexpr Eigen::Index stretches = 12;
constexpr Eigen::Index least_blocks = 8;
constexpr double greatest_correlation = 0.8;

Eigen::MatrixXd summed_by_stretch(const Eigen::MatrixXd& by_block) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(stretches, by_block.cols());
  for (Eigen::Index place = 0; place < by_block.rows(); ++place)
    sums.row(place * stretches / by_block.rows()) += by_block.row(place);
  return sums;
}

}  // namespace

double persistence(const Eigen::MatrixXd& by_block) {
  if (by_block.cols() < least_blocks) return 1.0;
  const auto n = static_cast<double>(by_block.cols());
  const Eigen::MatrixXd sums = summed_by_stretch(by_block);
  const Eigen::MatrixXd deviation = sums.colwise() - sums.rowwise().mean();
  const double squares = deviation.squaredNorm();
  if (!(squares > 0.0)) return 1.0;
  const Eigen::Index pairs = by_block.cols() - 1;
  const double lagged =
      deviation.leftCols(pairs).cwiseProduct(deviation.rightCols(pairs)).sum() / squares;
  const double correlation =
      std::clamp((lagged + 1.0 / n) / (1.0 - 3.0 / n), 0.0, greatest_correlation);
  return (1.0 + correlation) / (1.0 - correlation);
}

Eigen::MatrixXd as_independent(const Eigen::MatrixXd& by_block) {
  const double widening = std::sqrt(persistence(by_block));
  const Eigen::VectorXd mean = by_block.rowwise().mean();
  return (widening * (by_block.colwise() - mean)).colwise() + mean;
}

}  // namespace millwear::wear
