#include "wear/record/polar_load.h"

#include "mill/base/contract.h"
#include "wear/record/charge_position.h"

namespace millwear::wear {

PolarLoad no_polar_load(Eigen::Index bins) {
  PolarLoad none;
  none.values.fill(Eigen::MatrixXd::Zero(bins, polar_columns));
  return none;
}

Eigen::Index polar_column(double angle_from_six) {
  static_assert(degrees_around % polar_columns == 0);
  return degree_around(angle_from_six) / (degrees_around / polar_columns);
}

void add_polar(PolarLoad& sum, const PolarLoad& more) {
  expect(sum.values[0].rows() == more.values[0].rows(), "polar loads are summed bin by bin");
  for (std::size_t m = 0; m < polar_measures.size(); ++m) sum.values[m] += more.values[m];
}

}  // namespace millwear::wear
