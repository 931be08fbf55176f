#include "wear/numerics/block_means.h"

#include <cmath>

namespace millwear::wear {

Eigen::VectorXd block_means(const std::vector<double>& series, int blocks) {
  const auto length = static_cast<Eigen::Index>(series.size()) / blocks;
  if (length == 0) return {};
  return Eigen::Map<const Eigen::MatrixXd>(series.data(), length, blocks)
      .colwise()
      .mean()
      .transpose();
}

Eigen::VectorXd error_of_mean(const Eigen::MatrixXd& by_block) {
  const auto blocks = static_cast<double>(by_block.cols());
  if (by_block.cols() < 2) return Eigen::VectorXd::Constant(by_block.rows(), std::nan(""));
  const Eigen::VectorXd mean = by_block.rowwise().mean();
  return ((by_block.colwise() - mean).rowwise().squaredNorm() / (blocks * (blocks - 1.0)))
      .cwiseSqrt();
}

}  // namespace millwear::wear
