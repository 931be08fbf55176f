#include "wear/rate/load_rate.h"

#include <utility>

#include "wear/numerics/block_persistence.h"
#include "wear/rate/wear_law.h"
#include "wear/record/load_accumulator.h"

namespace millwear::wear {

Smoothing smoothing_of(const Case& mill) {
  return {mill.wear.smoothing, 0.5 * smallest_diameter(mill)};
}

LoadRate rate_of_load(const Case& mill, const WallLoad& recorded) {
  const auto load = coarsened(recorded, static_cast<int>(recorded.bins()) / mill.wear.bins);
  auto by_contact = weights_of(mill);
  const double corrosion = std::exchange(by_contact.corrosion, 0.0);
  const Eigen::VectorXd raw = depth_rate(by_contact, load);
  const Eigen::MatrixXd by_block = as_independent(depth_rate_by_block(by_contact, load));
  auto smooth = smoothed(load.bin_edges, raw, by_block, smoothing_of(mill));
  if (corrosion > 0.0) {
    smooth.rate.values.array() += corrosion;
    smooth.moved_share *= raw.sum() / smooth.rate.values.sum();
  }
  return {load, raw.array() + corrosion, by_block.array() + corrosion, std::move(smooth)};
}

}  // namespace millwear::wear
