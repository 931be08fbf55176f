#include "wear/calibrate/wear_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "wear/calibrate/angular_zones.h"
#include "wear/calibrate/path_prediction.h"
#include "wear/evolve/evolution.h"

namespace millwear::wear {
namespace {

using Eigen::VectorXd;

constexpr Eigen::Index bins = 120;
constexpr Eigen::Index zones = 6;

ArcCurve rate_on(const LinerProfile& profile, double leading, double rest) {
  const double length = arc_lengths(profile).back();
  ArcCurve curve{VectorXd::LinSpaced(bins + 1, 0.0, length), VectorXd::Constant(bins, rest)};
  curve.values.tail(bins / 2).setConstant(leading);
  return curve;
}

/// Two cycles under loads that double from the first to the second; the mechanisms are one half and
/// twice the campaign's law.
std::vector<PathCycle> two_cycles() {
  std::vector<PathCycle> cycles;
  LinerProfile liner = square_lifter();
  for (const double growth : {1.0, 2.0, 4.0}) {
    const ArcCurve rate = rate_on(liner, 2e-9 * growth, 1e-9 * growth);
    PathCycle cycle{liner, rate, {rate, rate}, {}};
    cycle.mechanisms[0].values *= 0.5;
    cycle.mechanisms[1].values *= 2.0;
    if (growth < 4.0)
      for (auto& step : evolve(std::vector<TimedLoad>{{0.0, liner, rate}},
                               lifter_area(square_lifter()), {0.1, 5, 0.02, 0.001, 10})
                            .steps)
        cycle.steps.push_back({step.accounted_area, std::move(step.profile)});
    if (!cycle.steps.empty()) liner = cycle.steps.back().profile;
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

class WearPathByPace : public testing::TestWithParam<PathPace> {};

// A mechanism of the campaign's own pattern follows its liners: at the time of every liner all
// channels have lost what that liner lost, whatever the factor.
TEST_P(WearPathByPace, PassesThroughTheCampaignsLiners) {
  const auto cycles = two_cycles();
  const WearPath path = wear_path(cycles, GetParam(), zones);
  ASSERT_EQ(path.pieces.size(), 10U);
  const LinerProfile& fresh = cycles[0].liner;
  const LinerProfile& last = cycles[1].steps.back().profile;
  for (const auto& factors : {Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(0.4, 0.9)}) {
    const PathLoss loss = loss_at(path, factors, time_of_path(path, factors));
    const VectorXd zone_losses = steel_by_zone(fresh, zones) - steel_by_zone(last, zones);
    EXPECT_LT((loss.lost.head(zones) - zone_losses).norm(), 1e-6 * zone_losses.norm());
    EXPECT_NEAR(loss.lost[path.channels.height()], lifter_height(fresh) - lifter_height(last),
                1e-8);
    EXPECT_NEAR(loss.lost[path.channels.plate()], plate_thickness(fresh) - plate_thickness(last),
                1e-8);
    EXPECT_LT((path.lost - loss.lost).norm(), 1e-8);
  }
}

// Twice the coefficient in half the time; the second mechanism is four times the first.
TEST_P(WearPathByPace, TakesTimeByTheCoefficients) {
  const WearPath path = wear_path(two_cycles(), GetParam(), zones);
  const double time = time_of_path(path, Eigen::Vector2d(1.0, 0.0));
  EXPECT_NEAR(time_of_path(path, Eigen::Vector2d(2.0, 0.0)), 0.5 * time, 1e-9 * time);
  EXPECT_NEAR(time_of_path(path, Eigen::Vector2d(0.0, 1.0)), 0.25 * time, 1e-9 * time);
}

INSTANTIATE_TEST_SUITE_P(Paces, WearPathByPace,
                         testing::Values(PathPace::section, PathPace::height));

// The loads double from liner to liner while 0.1 of the lifter goes, then again: with rates linear
// in the section, q = q0 (1 + x), a cycle takes its section / q0 times ln 2, against 1 and 1/2
// under the loads held. The length of the profile changes by a per cent.
TEST(WearPath, TakesTheRatesBetweenTwoLoadsAsLinear) {
  const auto cycles = two_cycles();
  const WearPath path = wear_path(cycles, PathPace::section, zones);
  const double section = 0.1 * lifter_area(square_lifter());
  const double rate = 2.0 * 1.5e-9 * arc_lengths(square_lifter()).back();
  const double expected = section / rate * std::log(2.0) * 1.5;
  EXPECT_NEAR(time_of_path(path, Eigen::Vector2d(0.0, 1.0)), expected, 0.02 * expected);
}

// The campaign wears the leading half alone, the mechanism the trailing half alone: its rate in the
// first zone is its own depth rate times the length there.
TEST(WearPath, KnowsPlacesThatOnlyTheOtherLawWears) {
  auto cycles = two_cycles();
  for (auto& cycle : cycles) {
    cycle.campaign = rate_on(cycle.liner, 2e-9, 0.0);
    cycle.mechanisms = {rate_on(cycle.liner, 0.0, 3e-9)};
  }
  const WearPath path = wear_path(cycles, PathPace::section, zones);
  const auto& rates = path.pieces.front().start;
  EXPECT_NEAR(rates.losses(1, 0), 3e-9 * length_by_zone(square_lifter(), zones)[1], 4e-12);
  EXPECT_EQ(rates.losses(4, 0), 0.0);
  EXPECT_NEAR(rates.pace[0], 3e-9 * 0.5 * arc_lengths(square_lifter()).back(), 2e-11);
}

TEST(WearPath, RefusesNoSteps) {
  auto cycles = two_cycles();
  EXPECT_THROW(static_cast<void>(wear_path({}, PathPace::section, zones)), std::logic_error);
  cycles[1].mechanisms.pop_back();
  EXPECT_THROW(static_cast<void>(wear_path(cycles, PathPace::section, zones)), std::logic_error);
  cycles.front().steps.clear();
  EXPECT_THROW(static_cast<void>(wear_path(cycles, PathPace::section, zones)), std::logic_error);
}

}  // namespace
}  // namespace millwear::wear
