#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "tests/verification/wear/noisy_campaign.h"

namespace millwear::wear {
namespace {

constexpr int campaigns = 24;

CampaignSettings settings_of(Scheme scheme) {
  return {.threshold = 0.15,
          .steps_per_cycle = 2,
          .height_limit = 0.0,
          .plate_limit = 0.0,
          .cycle_limit = 100,
          .scheme = scheme,
          .step_tolerance = 0.01,
          .largest_share = 0.15};
}

/// A square lifter, 0.1 m wide and high, on a round plate of 50 mm.
LinerProfile lifter_on_a_ring() {
  constexpr int facets = 8;
  constexpr double half_width = 0.05;
  const double half_pitch = 0.5 * sample_sector.pitch();
  const auto on_ring = [&](double angle) { return point_at(sample_sector, 1.0, angle); };
  LinerProfile liner{sample_sector, {}};
  for (int i = 0; i <= facets; ++i) {
    liner.nodes.push_back(on_ring(-half_pitch + i * (half_pitch - half_width) / facets));
  }
  liner.nodes.push_back(liner.nodes.back() + Eigen::Vector2d(0.0, 0.1));
  for (int i = facets; i >= 0; --i) {
    const Eigen::Vector2d here = liner.nodes[static_cast<std::size_t>(i)];
    if (i == facets) liner.nodes.emplace_back(-here.x(), liner.nodes.back().y());
    liner.nodes.emplace_back(-here.x(), here.y());
  }
  return liner;
}

/// A lifter under balls of 30 mm that wear it evenly; by places a load is known to 12 %.
KnownMill lifter_under_balls(double scatter) {
  return {lifter_on_a_ring(),
          lifter_area(lifter_on_a_ring()),
          0.0,
          {0.01, 0.015},
          0.05,
          0.5 * scatter,
          scatter};
}

struct Bias {
  double mean_error;  ///< of the campaigns, against exact loads [m]
  double scatter;     ///< between the campaigns [m]
};

Bias bias_of(const Eigen::VectorXd& noisy, double exact) {
  const double mean = noisy.mean();
  return {mean - exact,
          std::sqrt((noisy.array() - mean).square().sum() / static_cast<double>(noisy.size() - 1))};
}

void expect_small(const char* what, const Bias& bias, double exact) {
  std::printf("%s %.2f mm: bias %+.3f mm, scatter %.3f mm\n", what, 1e3 * exact,
              1e3 * bias.mean_error, 1e3 * bias.scatter);
  EXPECT_LT(std::abs(bias.mean_error), 0.5 * bias.scatter);
}

// The crest is the highest place of a noisy profile and the thinnest plate the lowest. What noise
// adds to them must stay small to what it scatters. The top of a square lifter is the worst case:
// all its places compete. Two dozen campaigns tell their mean to 0.2 of the scatter.
TEST(NoiseBias, OfHeightAndPlateIsSmallToTheirScatter) {
  constexpr double age = 1.5e7;
  for (const Scheme scheme : {Scheme::threshold, Scheme::adaptive}) {
    const auto exact = noisy_campaign(lifter_under_balls(1e-4), settings_of(scheme), 1, age).worn;
    Eigen::VectorXd heights(campaigns);
    Eigen::VectorXd plates(campaigns);
    for (int i = 0; i < campaigns; ++i) {
      const auto seed = static_cast<std::uint64_t>(i) + 1;
      const auto worn =
          noisy_campaign(lifter_under_balls(0.4), settings_of(scheme), seed, age).worn;
      heights[i] = lifter_height(worn);
      plates[i] = plate_thickness(worn);
    }
    std::printf("%s\n", name_of(scheme).data());
    expect_small("height", bias_of(heights, lifter_height(exact)), lifter_height(exact));
    expect_small("plate", bias_of(plates, plate_thickness(exact)), plate_thickness(exact));
  }
}

}  // namespace
}  // namespace millwear::wear
