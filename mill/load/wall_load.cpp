#include "mill/load/wall_load.h"

#include <cmath>

namespace millwear {

Eigen::VectorXd WallLoad::bin_widths() const {
  return bin_edges.tail(bins()) - bin_edges.head(bins());
}

Eigen::VectorXd WallLoad::bin_area() const { return bin_widths() * slice_length; }

Eigen::VectorXd WallLoad::total(Measure measure) const {
  return values[static_cast<std::size_t>(measure)].rowwise().sum();
}

Eigen::MatrixXd WallLoad::by_block(Measure measure) const {
  const Eigen::MatrixXd& all = values[static_cast<std::size_t>(measure)];
  const auto blocks = static_cast<Eigen::Index>(block_count);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(bins(), blocks);
  for (std::size_t c = 0; c < class_count; ++c) {
    sum += all.middleCols(static_cast<Eigen::Index>(c) * blocks, blocks);
  }
  return sum;
}

double path_over_slip(const WallLoad& load) {
  const double slid = load.total(Measure::sliding_work).sum();
  return slid > 0.0 ? load.total(Measure::path_work).sum() / slid : std::nan("");
}

}  // namespace millwear
