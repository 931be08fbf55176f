#include <gtest/gtest.h>

#include <cmath>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "wear/evolve/evolution.h"

namespace millwear::wear {
namespace {

constexpr double rate = 1e-9;
constexpr double half_width = 0.03;
constexpr double height = 0.1;

/// A ridge of two faces on a straight plate; its crest is node 3, its leading foot node 4.
LinerProfile ridge() {
  const double half = 0.5 * sample_sector.pitch();
  return {sample_sector,
          {point_at(sample_sector, 1.0, -half),
           {-0.2, 0.0},
           {-half_width, 0.0},
           {0.0, height},
           {half_width, 0.0},
           {0.2, 0.0},
           point_at(sample_sector, 1.0, half)}};
}

struct WornRidge {
  double depth;   ///< of the leading face [m]
  double height;  ///< [m]
  double crest;   ///< place of the crest along the rotation [m]
};

/// After points have worn the leading face alone, in so many steps and bins.
WornRidge worn_from_one_side(Eigen::Index bins, int steps) {
  const LinerProfile liner = ridge();
  const auto lengths = arc_lengths(liner);
  ArcCurve load{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, lengths.back()),
                Eigen::VectorXd::Zero(bins)};
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const double s = (static_cast<double>(bin) + 0.5) * load.bin_width();
    if (s > lengths[3] && s < lengths[4]) load.values[bin] = rate;
  }
  const auto evolution = evolve(std::vector<TimedLoad>{{0.0, liner, load}}, lifter_area(liner),
                                {0.4, steps, -1.0, 0.0, 1});
  WornRidge worn{0.0, 0.0, 0.0};
  for (const auto& step : evolution.steps) worn.depth += rate * step.duration;
  const auto& profile = evolution.steps.back().profile;
  worn.height = lifter_height(profile);
  for (const auto& node : profile.nodes)
    if (std::abs(radius_of(sample_sector, node) - crest_radius(profile)) < 1e-9)
      worn.crest = node.x();
  return worn;
}

// The leading face recedes by d along its normal, so the crest slides down the trailing face:
// d / sin(2 a) along it, a the half angle of the ridge. However fine the bins.
TEST(Ridge, SlidesDownTheFaceThatDoesNotWear) {
  const double angle = std::atan2(half_width, height);
  for (const Eigen::Index bins : {60, 120, 240, 480}) {
    const WornRidge worn = worn_from_one_side(bins, 20);
    const double along = worn.depth / std::sin(2.0 * angle);
    EXPECT_NEAR(worn.height, height - along * std::cos(angle), 0.01 * along) << bins;
    EXPECT_NEAR(worn.crest, -along * std::sin(angle), 0.01 * along) << bins;
  }
}

// First order in the step.
TEST(Ridge, ErrsByLessInShorterSteps) {
  const double angle = std::atan2(half_width, height);
  const auto error = [&](int steps) {
    const WornRidge worn = worn_from_one_side(120, steps);
    return std::abs(worn.height - height + worn.depth / std::sin(2.0 * angle) * std::cos(angle));
  };
  EXPECT_LT(error(20), 0.4 * error(5));
}

}  // namespace
}  // namespace millwear::wear
