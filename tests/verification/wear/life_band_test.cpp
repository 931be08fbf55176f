#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/sample_profiles.h"
#include "tests/verification/wear/noisy_campaign.h"

namespace millwear::wear {
namespace {

constexpr double depth_to_limit = 0.025;

struct Campaign {
  double life;
  Band band;
  double predicted_error;  ///< standard error of the life, from the band's width
};

/// The plate of a mill, loaded by points.
Campaign campaign(const CampaignSettings& settings, double growth, std::uint64_t seed) {
  const LinerProfile ring = bare_ring(1.0, 12);
  const double section = depth_to_limit * arc_lengths(bare_ring()).back();
  const KnownMill mill{ring, section, growth, {0.0, 0.0}, 0.0, 0.2, 0.2};
  const auto worn = noisy_campaign(mill, settings, seed);
  const Eigen::VectorXd replicates =
      lives_of(worn.cycles, bands_of(worn.cycles, settings.scheme), settings);
  const Band band = band_of(replicates);
  // A rate near zero makes a life without limit, and so the replicates have no variance.
  return {worn.duration, band, standard_error_of(band)};
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
