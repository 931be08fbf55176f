#include "wear/rate/load_rate.h"

#include <utility>

#include "wear/numerics/block_persistence.h"
#include "wear/rate/smoothing_error.h"
#include "wear/rate/wear_law.h"
#include "wear/record/load_accumulator.h"

namespace millwear::wear {
namespace {

RollingBalls balls_of(const WearSettings& settings, const std::vector<ParticleClass>& classes,
                      const WallLoad& load) {
  const LawWeights weights = weights_of(settings.mechanisms, classes);
  double sum = 0.0;
  double moment = 0.0;
  for (Eigen::Index kind = 0; kind < weights.per_energy.cols(); ++kind) {
    LawWeights alone{Eigen::MatrixXd::Zero(weights.per_energy.rows(), weights.per_energy.cols()),
                     0.0};
    alone.per_energy.col(kind) = weights.per_energy.col(kind);
    const double worn = depth_rate(alone, load).sum();
    sum += worn;
    moment += worn * 0.5 * classes[static_cast<std::size_t>(kind)].diameter;
  }
  const double smallest = 0.5 * smallest_diameter(classes);
  return {settings.shadowed_steel == ShadowedSteel::closing ? smallest : 0.0,
          sum > 0.0 ? moment / sum : smallest};
}

}  // namespace

Rolling rolling_of(const LoadRate& rate) {
  return {rate.smoothed.path, rate.smoothed.per_path, rate.balls, rate.corrosion};
}

LoadRate rate_of_load(const WearSettings& settings, const std::vector<ParticleClass>& classes,
                      const LinerProfile& liner, const WallLoad& recorded) {
  const auto load = coarsened(recorded, static_cast<int>(recorded.bins()) / settings.bins);
  const RollingBalls balls = balls_of(settings, classes, load);
  auto by_contact = weights_of(settings.mechanisms, classes);
  const double corrosion = std::exchange(by_contact.corrosion, 0.0);
  const Eigen::VectorXd raw = depth_rate(by_contact, load);
  const Eigen::MatrixXd by_block = as_independent(depth_rate_by_block(by_contact, load));
  const Smoothing how{settings.smoothing, settings.resolution.value_or(smallest_diameter(classes)),
                      centre_path(liner, settings.bins, balls)};
  auto smooth = smoothed(load.bin_edges, raw, by_block, how);
  if (corrosion > 0.0) {
    smooth.rate.values.array() += corrosion;
    smooth.moved_share *= raw.sum() / smooth.rate.values.sum();
  }
  return {load,     raw.array() + corrosion, by_block.array() + corrosion,
          how,      std::move(smooth),       balls,
          corrosion};
}

double peak_error_of_load(const WearSettings& settings, const std::vector<ParticleClass>& classes,
                          const LinerProfile& liner, const WallLoad& recorded) {
  return peak_error(rate_of_load(settings, classes, liner, recorded).smoothed);
}

}  // namespace millwear::wear
