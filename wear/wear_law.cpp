#include "wear/wear_law.h"

#include "mill/failure.h"

namespace millwear::wear {
namespace {

void check(const WallLoad& load) {
  if (!(load.bin_area().minCoeff() > 0.0)) {
    throw InputError("a bin of the wall load has no area; its edges must increase");
  }
  if (load.rows <= 0 || !(load.duration > 0.0) || load.block_count == 0) {
    throw InputError("a wall load needs rows, a duration and time blocks above zero");
  }
}

}  // namespace

Eigen::VectorXd depth_rate(const Archard& law, const WallLoad& load) {
  check(load);
  const Eigen::ArrayXd work_per_area =
      load.total(Measure::sliding_work).array() / load.bin_area().array();
  return law.specific_wear_rate * work_per_area / (load.rows * load.duration);
}

Eigen::MatrixXd depth_rate_by_block(const Archard& law, const WallLoad& load) {
  check(load);
  const double block_duration = load.duration / static_cast<double>(load.block_count);
  const Eigen::ArrayXXd work_per_area =
      load.by_block(Measure::sliding_work).array().colwise() / load.bin_area().array();
  return law.specific_wear_rate * work_per_area / (load.rows * block_duration);
}

}  // namespace millwear::wear
