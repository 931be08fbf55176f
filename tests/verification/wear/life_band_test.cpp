#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/support/sample_profiles.h"
#include "wear/band/campaign_band.h"
#include "wear/evolve/evolution.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 40;
constexpr Eigen::Index blocks = 10;
constexpr double depth_rate = 1e-9;
constexpr double depth_to_limit = 0.025;

/// The plate of a mill; it wears the faster the more it has lost.
double true_rate(const LinerProfile& liner, double growth) {
  const double worn = radius_of(liner.sector, liner.nodes.front()) - liner.sector.plate_radius;
  return depth_rate * (1.0 + growth * worn);
}

/// What a measurement shows of an even rate: time blocks that scatter as a whole, and by place.
struct Measurement {
  Eigen::MatrixXd by_block;
  SmoothedLoss loss;
};

Measurement measured(const LinerProfile& liner, double rate, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd by_block(bins, blocks);
  for (Eigen::Index block = 0; block < blocks; ++block) {
    const double whole = 0.2 * normal(random);
    for (Eigen::Index bin = 0; bin < bins; ++bin)
      by_block(bin, block) = rate * std::max(0.0, 1.0 + whole + 0.2 * normal(random));
  }
  return {by_block, smoothed(Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(liner).back()),
                             by_block.rowwise().mean(), by_block)};
}

struct Campaign {
  double life;
  Band band;
  double predicted_error;  ///< standard error of the life, from the band's width
};

Campaign campaign(const CampaignSettings& settings, double growth, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<WornCycle> cycles;
  std::vector<TimedLoad> loads;
  LinerProfile liner = bare_ring(1.0, 12);
  double time = 0.0;
  for (auto end = EvolutionEnd::load_spent; end == EvolutionEnd::load_spent;) {
    const auto [by_block, loss] = measured(liner, true_rate(liner, growth), random);
    loads.push_back({time, liner, loss.rate, by_block});
    const auto evolution =
        evolve(loads, depth_to_limit * arc_lengths(bare_ring()).back(), settings);
    cycles.push_back({loads.back(),
                      rate_replicates(loss, 200, seed * 1000 + cycles.size(), ReplicateOf::noise),
                      {}});
    for (const auto& step : evolution.steps) {
      cycles.back().steps.push_back({step.duration, step.profile});
      time += step.duration;
    }
    liner = evolution.steps.back().profile;
    end = evolution.end;
  }
  const Eigen::VectorXd replicates = lives_of(cycles, bands_of(cycles, settings.scheme), settings);
  const Band band = band_of(replicates);
  // A rate near zero makes a life without limit, and so the replicates have no variance.
  return {time, band, (band.high - band.low) / (2.0 * 1.96)};
}

struct Coverage {
  double share;        ///< of the bands that hold the true life
  double error_ratio;  ///< predicted standard error over the real scatter
};

Coverage coverage(Scheme scheme, double growth, int campaigns) {
  const CampaignSettings settings{.threshold = 0.15,
                                  .steps_per_cycle = 2,
                                  .height_limit = -1.0,
                                  .plate_limit = 0.05 - depth_to_limit,
                                  .cycle_limit = 100,
                                  .scheme = scheme,
                                  .step_tolerance = 0.01,
                                  .largest_share = 0.15};
  std::vector<Campaign> all;
  double mean = 0.0;
  for (int i = 0; i < campaigns; ++i) {
    all.push_back(campaign(settings, growth, static_cast<std::uint64_t>(i) + 1));
    mean += all.back().life / campaigns;
  }
  Coverage found{0.0, 0.0};
  double scatter = 0.0;
  double predicted = 0.0;
  for (const auto& one : all) {
    // The mean life in place of the exact one: this is about noise, not about the steps in time.
    found.share += (one.band.low <= mean && mean <= one.band.high) ? 1.0 / campaigns : 0.0;
    scatter += (one.life - mean) * (one.life - mean);
    predicted += one.predicted_error * one.predicted_error;
  }
  found.error_ratio = std::sqrt(predicted / scatter);
  return found;
}

// The whole way from noisy time blocks to the band of the life. With growth, a liner that is ahead
// wears faster, and without that in the replicates their scatter is too small.
TEST(LifeBand, HoldsTheLife) {
  for (const Scheme scheme : {Scheme::threshold, Scheme::adaptive}) {
    for (const double growth : {0.0, 80.0}) {
      const Coverage found = coverage(scheme, growth, 100);
      std::printf("%-9s growth %3.0f/m: the band holds the life in %.0f %%, error / scatter %.2f\n",
                  name_of(scheme).data(), growth, 100.0 * found.share, found.error_ratio);
      EXPECT_GE(found.share, 0.88);  // a hundred campaigns tell it to 3 %
      EXPECT_LE(found.share, 0.99);
      EXPECT_NEAR(found.error_ratio, 1.1, 0.25);
    }
  }
}

}  // namespace
}  // namespace millwear::wear
