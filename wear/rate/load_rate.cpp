#include "wear/rate/load_rate.h"

#include <utility>

#include "wear/numerics/block_persistence.h"
#include "wear/rate/wear_law.h"
#include "wear/record/load_accumulator.h"

namespace millwear::wear {

Smoothing smoothing_of(const WearSettings& settings, const std::vector<ParticleClass>& classes) {
  return {settings.smoothing, 0.5 * smallest_diameter(classes)};
}

LoadRate rate_of_load(const WearSettings& settings, const std::vector<ParticleClass>& classes,
                      const WallLoad& recorded) {
  const auto load = coarsened(recorded, static_cast<int>(recorded.bins()) / settings.bins);
  auto by_contact = weights_of(settings.mechanisms, classes);
  const double corrosion = std::exchange(by_contact.corrosion, 0.0);
  const Eigen::VectorXd raw = depth_rate(by_contact, load);
  const Eigen::MatrixXd by_block = as_independent(depth_rate_by_block(by_contact, load));
  auto smooth = smoothed(load.bin_edges, raw, by_block, smoothing_of(settings, classes));
  if (corrosion > 0.0) {
    smooth.rate.values.array() += corrosion;
    smooth.moved_share *= raw.sum() / smooth.rate.values.sum();
  }
  return {load, raw.array() + corrosion, by_block.array() + corrosion, std::move(smooth)};
}

}  // namespace millwear::wear
