#include "wear/evolve/evolution.h"

#include <gtest/gtest.h>

#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 150;

ArcCurve even_rate(const LinerProfile& profile, double rate) {
  return {Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
          Eigen::VectorXd::Constant(bins, rate)};
}

/// Only the lifter wears.
ArcCurve lifter_rate(const LinerProfile& profile, double rate) {
  ArcCurve curve = even_rate(profile, rate);
  const auto lengths = arc_lengths(profile);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double centre = (static_cast<double>(i) + 0.5) * curve.bin_width();
    if (centre < lengths[2] || centre > lengths[5]) curve.values[i] = 0.0;
  }
  return curve;
}

CampaignSettings settings(double threshold, double height_limit, double plate_limit) {
  return {threshold, 5, height_limit, plate_limit, 10};
}

Evolution worn_once(const LinerProfile& profile, const ArcCurve& rate,
                    const CampaignSettings& campaign) {
  return evolve(std::vector<TimedLoad>{{0.0, profile, rate}}, lifter_area(profile), campaign);
}

TEST(Evolution, TakesTheThresholdInEvenSteps) {
  const auto profile = square_lifter();
  const double lifter = lifter_area(profile);
  const auto evolution = worn_once(profile, even_rate(profile, 1e-9), settings(0.1, 0.02, 0.0));
  ASSERT_EQ(evolution.steps.size(), 5U);
  EXPECT_EQ(evolution.end, EvolutionEnd::load_spent);
  for (const auto& step : evolution.steps) {
    EXPECT_NEAR(step.removed_area, 0.02 * lifter, 1e-9 * 0.02 * lifter);
    EXPECT_NEAR(step.accounted_area, step.removed_area, 1e-9 * step.removed_area);
  }
  EXPECT_NEAR(steel_area(profile) - steel_area(evolution.steps.back().profile), 0.1 * lifter,
              1e-9 * lifter);
}

// The first step takes what the bins say: rate * length of the profile * duration.
TEST(Evolution, AccountsForTheBins) {
  const auto profile = square_lifter();
  const auto evolution = worn_once(profile, even_rate(profile, 1e-9), settings(0.1, 0.02, 0.0));
  const auto& first = evolution.steps.front();
  EXPECT_NEAR(first.accounted_area, 1e-9 * arc_lengths(profile).back() * first.duration,
              1e-12 * first.accounted_area);
}

// Twice the rate wears the same shape in half the time.
TEST(Evolution, TimeGoesWithTheRate) {
  const auto profile = square_lifter();
  const auto wear = [&](double rate) {
    return worn_once(profile, even_rate(profile, rate), settings(0.1, 0.02, 0.0)).steps.back();
  };
  EXPECT_NEAR(wear(1e-9).duration, 2.0 * wear(2e-9).duration, 1e-9 * wear(1e-9).duration);
  EXPECT_NEAR(lifter_height(wear(1e-9).profile), lifter_height(wear(2e-9).profile), 1e-9);
}

TEST(Evolution, MeetsTheHeightLimit) {
  const auto profile = square_lifter();
  const double limit = lifter_height(profile) - 0.0042;
  const auto evolution = worn_once(profile, lifter_rate(profile, 1e-9), settings(0.5, limit, 0.0));
  EXPECT_EQ(evolution.end, EvolutionEnd::height_limit);
  EXPECT_NEAR(lifter_height(evolution.steps.back().profile), limit, 1e-6);
  EXPECT_NEAR(evolution.steps.back().accounted_area, evolution.steps.back().removed_area,
              1e-9 * evolution.steps.back().removed_area);
}

TEST(Evolution, MeetsThePlateLimit) {
  const auto profile = square_lifter();
  const double limit = plate_thickness(profile) - 0.0031;
  const auto evolution = worn_once(profile, even_rate(profile, 1e-9), settings(0.9, 0.0, limit));
  EXPECT_EQ(evolution.end, EvolutionEnd::plate_limit);
  EXPECT_NEAR(plate_thickness(evolution.steps.back().profile), limit, 1e-6);
}

TEST(Evolution, TakesNoStepBelowALimit) {
  const auto profile = square_lifter();
  const auto evolution = worn_once(profile, even_rate(profile, 1e-9), settings(0.1, 0.2, 0.0));
  EXPECT_TRUE(evolution.steps.empty());
  EXPECT_EQ(evolution.end, EvolutionEnd::height_limit);
}

TEST(Evolution, RefusesALoadOfNothing) {
  const auto profile = square_lifter();
  EXPECT_THROW(
      static_cast<void>(worn_once(profile, even_rate(profile, 0.0), settings(0.1, 0.02, 0.0))),
      ResultRejected);
}

}  // namespace
}  // namespace millwear::wear
