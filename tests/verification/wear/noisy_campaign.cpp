#include "tests/verification/wear/noisy_campaign.h"

#include <algorithm>
#include <random>

#include "wear/evolve/evolution.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 80;
constexpr Eigen::Index blocks = 10;

/// Rate of a flat of the liner: it wears the faster the more it has lost.
double true_rate(const KnownMill& mill, const LinerProfile& liner) {
  const double worn = radius_of(liner.sector, liner.nodes.front()) - liner.sector.plate_radius;
  return known_depth_rate * (1.0 + mill.growth * worn);
}

struct Measurement {
  TimedLoad load;
  SmoothedLoss loss;
};

Measurement measured(const KnownMill& mill, const LinerProfile& liner, double time,
                     std::mt19937_64& random) {
  const double rate = true_rate(mill, liner);
  const Eigen::VectorXd path = centre_path(liner, bins, mill.balls);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd by_block(bins, blocks);
  for (Eigen::Index block = 0; block < blocks; ++block) {
    const double whole = mill.whole_scatter * normal(random);
    for (Eigen::Index bin = 0; bin < bins; ++bin) {
      const double noise = whole + mill.bin_scatter * normal(random);
      by_block(bin, block) = rate * path[bin] * std::max(0.0, 1.0 + noise);
    }
  }
  const auto edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(liner).back());
  const auto loss = smoothed(edges, by_block.rowwise().mean(), by_block,
                             {.resolution = mill.resolution, .centre_path = path});
  return {{time, liner, loss.rate, by_block, Rolling{path, loss.per_path, mill.balls}}, loss};
}

}  // namespace

NoisyCampaign noisy_campaign(const KnownMill& mill, const CampaignSettings& settings,
                             std::uint64_t seed, double longest) {
  std::mt19937_64 random(seed);
  NoisyCampaign campaign{{}, mill.liner, 0.0};
  std::vector<TimedLoad> loads;
  for (auto end = EvolutionEnd::load_spent; end == EvolutionEnd::load_spent;) {
    const auto [load, loss] = measured(mill, campaign.worn, campaign.duration, random);
    loads.push_back(load);
    const auto evolution = evolve(loads, mill.section, settings, longest - campaign.duration);
    const std::uint64_t own_seed = seed * 1000 + campaign.cycles.size();
    campaign.cycles.push_back({load, rate_replicates(loss, 200, own_seed, ReplicateOf::noise), {}});
    for (const auto& step : evolution.steps) {
      campaign.cycles.back().steps.push_back({step.duration, step.profile});
      campaign.duration += step.duration;
    }
    campaign.worn = evolution.steps.back().profile;
    end = evolution.end;
  }
  return campaign;
}

}  // namespace millwear::wear
