#include "wear/rate/wear_law.h"

#include <fmt/format.h>

#include <stdexcept>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

void check(const LawWeights& weights, const WallLoad& load) {
  if (!(load.bin_area().minCoeff() > 0.0)) {
    throw InputError("a bin of the wall load has no area; its edges must increase");
  }
  if (load.rows <= 0 || !(load.duration > 0.0) || load.block_count == 0) {
    throw InputError("a wall load needs rows, a duration and time blocks above zero");
  }
  if (weights.per_energy.rows() != static_cast<Eigen::Index>(measure_count) ||
      weights.per_energy.cols() != static_cast<Eigen::Index>(load.class_count)) {
    throw InputError(
        fmt::format("the wear law is for {} particle classes and the wall load "
                    "has {}; they must be of the same charge",
                    weights.per_energy.cols(), load.class_count));
  }
}

/// The values of one measure and class, bins x blocks.
Eigen::MatrixXd blocks_of(const WallLoad& load, Eigen::Index measure, Eigen::Index kind) {
  const auto blocks = static_cast<Eigen::Index>(load.block_count);
  return load.values[static_cast<std::size_t>(measure)].middleCols(kind * blocks, blocks);
}

/// Bins below zero become zero, and the others shrink so that the sum stays.
Eigen::VectorXd losses_only(const Eigen::VectorXd& energy) {
  if (!(energy.minCoeff() < 0.0)) return energy;
  const Eigen::VectorXd losses = energy.cwiseMax(0.0);
  const double sum = energy.sum();
  if (!(sum > 0.0)) return Eigen::VectorXd::Zero(energy.size());
  return losses * (sum / losses.sum());
}

/// Calls `add(weight, blocks)` for every measure and class that the law weighs.
template <typename Add>
void for_each_term(const LawWeights& weights, const WallLoad& load, const Add& add) {
  for (Eigen::Index measure = 0; measure < weights.per_energy.rows(); ++measure) {
    for (Eigen::Index kind = 0; kind < weights.per_energy.cols(); ++kind) {
      if (const double weight = weights.per_energy(measure, kind); weight > 0.0) {
        add(weight, blocks_of(load, measure, kind));
      }
    }
  }
}

}  // namespace

Measure measure_of(WearLaw law) {
  switch (law) {
    case WearLaw::archard:
      return Measure::sliding_work;
    case WearLaw::finnie:
      return Measure::finnie;
    case WearLaw::normal_dissipation:
      return Measure::normal_dissipation;
    case WearLaw::excess_energy:
      return Measure::excess_energy;
    case WearLaw::shear_dissipation:
    case WearLaw::shear_impact_energy:
      return Measure::shear_dissipation;
    case WearLaw::incident_energy:
      return Measure::incident_energy;
    case WearLaw::corrosion:
      break;
  }
  throw std::logic_error("this wear law goes with no measure");
}

LawWeights weights_of(const WearMechanism& mechanism, const std::vector<ParticleClass>& classes) {
  const auto class_count = static_cast<Eigen::Index>(classes.size());
  LawWeights weights{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(measure_count), class_count),
                     mechanism.depth_rate};
  for (Eigen::Index kind = 0; kind < class_count; ++kind) {
    if (concerns(mechanism, classes[static_cast<std::size_t>(kind)])) {
      weights.per_energy(static_cast<Eigen::Index>(measure_of(mechanism.law)), kind) =
          mechanism.specific_wear_rate;
    }
  }
  return weights;
}

LawWeights weights_of(const std::vector<WearMechanism>& mechanisms,
                      const std::vector<ParticleClass>& classes) {
  LawWeights sum{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(measure_count),
                                       static_cast<Eigen::Index>(classes.size())),
                 0.0};
  for (const WearMechanism& mechanism : mechanisms) {
    const LawWeights weights = weights_of(mechanism, classes);
    sum.per_energy += weights.per_energy;
    sum.corrosion += weights.corrosion;
  }
  return sum;
}

Eigen::VectorXd depth_rate(const LawWeights& weights, const WallLoad& load) {
  check(weights, load);
  Eigen::VectorXd volume = Eigen::VectorXd::Zero(load.bins());
  for_each_term(weights, load, [&](double weight, const Eigen::MatrixXd& blocks) {
    volume += weight * losses_only(blocks.rowwise().sum());
  });
  return weights.corrosion + volume.array() / load.bin_area().array() / (load.rows * load.duration);
}

Eigen::MatrixXd depth_rate_by_block(const LawWeights& weights, const WallLoad& load) {
  check(weights, load);
  const auto block_count = static_cast<double>(load.block_count);
  Eigen::MatrixXd volume =
      Eigen::MatrixXd::Zero(load.bins(), static_cast<Eigen::Index>(load.block_count));
  for_each_term(weights, load, [&](double weight, const Eigen::MatrixXd& blocks) {
    const Eigen::VectorXd sum = blocks.rowwise().sum();
    const Eigen::VectorXd shift = (losses_only(sum) - sum) / block_count;
    volume += weight * (blocks.colwise() + shift);
  });
  const double block_duration = load.duration / block_count;
  return weights.corrosion +
         volume.array().colwise() / load.bin_area().array() / (load.rows * block_duration);
}

}  // namespace millwear::wear
