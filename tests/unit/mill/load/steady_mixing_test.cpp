#include "mill/load/steady_mixing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/example_case.h"

namespace millwear {
namespace {

using Series = std::vector<double>;

/// Sums to nothing over the pieces of each half window.
Series with_noise(Series series, double amplitude) {
  for (std::size_t i = 0; i < series.size(); ++i) series[i] += i % 2 == 0 ? amplitude : -amplitude;
  return series;
}

// 100 in the first window, 90 in the second: 10 of 95.
TEST(DriftOf, AStepIsItsHeight) {
  const Drift drift = drift_of(Series{-100, -100, -100, -100, -90, -90, -90, -90});
  EXPECT_DOUBLE_EQ(drift.relative, 10.0 / 95.0);
  EXPECT_EQ(drift.limit, 0.05);
  EXPECT_FALSE(is_steady(drift));
}

TEST(DriftOf, AConstantHasNone) {
  const Drift drift = drift_of(Series(8, -150e3));
  EXPECT_EQ(drift.relative, 0.0);
  EXPECT_TRUE(is_steady(drift));
}

TEST(DriftOf, LooksAtTheLastTwoWindowsOnly) {
  Series series(8, 100.0);
  series.insert(series.begin(), {0.0, 500.0, -30.0});
  EXPECT_EQ(drift_of(series).relative, 0.0);
}

// Both windows have the mean 105, on either side of a turning point.
TEST(DriftOf, ATurningPointIsADrift) {
  const Drift drift = drift_of(Series{100, 100, 110, 110, 110, 110, 100, 100});
  EXPECT_DOUBLE_EQ(drift.relative, 10.0 / 105.0);
  EXPECT_FALSE(is_steady(drift));
}

// A swing that takes just one window leaves no mean of a window and no turning point to be seen.
TEST(DriftOf, ASwingOfAWholeWindowIsADrift) {
  const Drift drift = drift_of(Series{100, 100, 110, 110, 100, 100, 110, 110});
  EXPECT_DOUBLE_EQ(drift.relative, 10.0 / 105.0);
  EXPECT_FALSE(is_steady(drift));
}

// Pieces of 100 +- 10: s^2 = 20^2 / 2 = 200, the error of a difference of two means of four is
// sqrt(200 / 2) = 10, and twice that is 20 % of the mean, of which 15 % are allowed. +- 5 is half.
TEST(DriftOf, NoiseWidensTheLimitUpToABound) {
  const Drift quiet = drift_of(with_noise(Series(8, 100.0), 1.0));
  EXPECT_NEAR(quiet.relative, 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(quiet.limit, 0.05);
  EXPECT_DOUBLE_EQ(drift_of(with_noise(Series(8, 100.0), 5.0)).limit, 0.10);
  EXPECT_DOUBLE_EQ(drift_of(with_noise(Series(8, 100.0), 10.0)).limit, 0.15);
  const Series step = {100, 100, 100, 100, 108, 108, 108, 108};
  EXPECT_FALSE(is_steady(drift_of(step)));
  EXPECT_TRUE(is_steady(drift_of(with_noise(step, 5.0))));
}

TEST(DriftOf, AMeanOfNothingIsNotSteady) {
  EXPECT_FALSE(is_steady(drift_of(Series(8, 0.0))));
  EXPECT_FALSE(is_steady(drift_of(Series{1, 1, 1, 1, -1, -1, -1, -1})));
  EXPECT_FALSE(is_steady(drift_of(Series(8, std::nan("")))));
}

TEST(DriftOf, WantsTwoWindows) {
  EXPECT_THROW(static_cast<void>(drift_of(Series(7, 1.0))), std::invalid_argument);
}

// 52 rows: two pitches are the fewest above a thirty-second of a revolution, seven of these pieces
// the fewest above a quarter, and 104 pitches are 52 pieces.
TEST(MixingPlan, IsOfWholePitches) {
  Case mill = example_case();
  mill.liner.sector.rows = 52;
  const auto plan = mixing_plan(mill, {4e-5, 100});
  EXPECT_EQ(plan.piece, 200);
  EXPECT_EQ(plan.left_out, 1400);
  EXPECT_EQ(plan.most, 10400);
  EXPECT_EQ(plan.revolution, 5200);
  EXPECT_EQ(least_steps(plan), 3000);
  mill.dem.mix_revolutions = 0.99;  // 51.48 pitches
  EXPECT_EQ(mixing_plan(mill, {4e-5, 100}).most, 5200);
}

TEST(MixingPlan, OfFewRowsTakesAPitchForAPiece) {
  const auto plan = mixing_plan(example_case(), {4e-5, 100});
  EXPECT_EQ(plan.piece, 100);
  EXPECT_EQ(plan.left_out, 300);
  EXPECT_EQ(plan.most, 2400);
}

constexpr MixingPlan of_seed_mill{
    .piece = 328, .left_out = 2296, .most = 17056, .revolution = 8528};

/// Torque [kN m] and kinetic energy [kJ] of an 8 m mill from its packing on, by two of its 52
/// pitches. It overshoots, comes back, stands still for a while, and rises by a fifth.
std::vector<MixedPiece> after_packing() {
  constexpr std::array<std::array<double, 2>, 20> pieces{
      {{-69, 16},  {-83, 62},  {-157, 123}, {-185, 132}, {-101, 78}, {-75, 68},  {-135, 65},
       {-134, 68}, {-147, 66}, {-152, 64},  {-140, 70},  {-145, 81}, {-150, 95}, {-173, 99},
       {-185, 93}, {-175, 88}, {-167, 83},  {-145, 80},  {-169, 78}, {-181, 76}}};
  std::vector<MixedPiece> series;
  for (const auto& piece : pieces) series.push_back({piece[0], piece[1]});
  return series;
}

TEST(MixingState, OfAnOvershootAndItsSwingsIsADrift) {
  const auto series = after_packing();
  for (std::size_t count = 1; count <= series.size(); ++count) {
    const std::span so_far(series.data(), count);
    EXPECT_EQ(mixing_state(of_seed_mill, so_far), MixingState::drifts) << count;
    EXPECT_EQ(mixing_drift(of_seed_mill, so_far).has_value(), count >= 15) << count;
  }
}

TEST(MixingState, AsksForTorqueAndEnergyBoth) {
  std::vector<MixedPiece> series(20, {-100.0, 50.0});
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::steady);
  for (std::size_t i = 16; i < 20; ++i) series[i].kinetic_energy = 55.0;
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::drifts);
  for (std::size_t i = 16; i < 20; ++i) series[i] = {-110.0, 50.0};
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::drifts);
}

// The swings die out: from about 165 kN m and 80 kJ on it is steady as soon as two windows show it.
TEST(MixingState, IsSteadyOnceTheSwingsAreOver) {
  auto series = after_packing();
  long count = 0;
  while (mixing_state(of_seed_mill, series) == MixingState::drifts) {
    const double swing = 4.0 * std::exp(-0.2 * static_cast<double>(count)) *
                         std::cos(static_cast<double>(count) * std::numbers::pi / 6.0);
    series.push_back({-165.0 - swing, 78.0 - swing});
    ++count;
  }
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::steady);
  EXPECT_GE(count, 1);
  EXPECT_LE(count, 8);
}

// The same packing, and nothing but a torque and an energy that grow by 3 % a piece afterwards.
TEST(MixingState, OfALastingDriftEndsAtTheMost) {
  auto series = after_packing();
  while (mixing_state(of_seed_mill, series) == MixingState::drifts)
    series.push_back({1.03 * series.back().torque, 1.03 * series.back().kinetic_energy});
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::at_most);
  EXPECT_EQ(series.size(), 52U);
}

/// 200 and 100 particles of two classes on the liner, of which `of_first` more are of the first.
MixedPiece with_classes(double of_first) {
  return {-100.0, 50.0, {200.0 + of_first, 100.0 - of_first}};
}

TEST(MixingState, AsksForTheClassesOnTheLinerToo) {
  std::vector<MixedPiece> series(15, with_classes(0.0));
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::steady);
  for (std::size_t i = 11; i < 15; ++i) series[i] = with_classes(40.0);
  EXPECT_EQ(mixing_state(of_seed_mill, series), MixingState::drifts);
}

// Shares 2/3 and 1/3, then 0.8 and 0.2: of the first 0.1333 over its mean 0.7333, and by chance
// sqrt((1 - p) / p * 2 / 300), 3.69 errors; of the second 3.69 as well, but for rounding.
TEST(ClassDrift, IsOfSharesAgainstTheChanceOfCounts) {
  std::vector<MixedPiece> series(15, with_classes(0.0));
  for (std::size_t i = 11; i < 15; ++i) series[i] = with_classes(40.0);
  const auto drift = class_drift(of_seed_mill, series);
  ASSERT_TRUE(drift);
  const double share =
      drift->particle_class == 0 ? 0.5 * (2.0 / 3.0 + 0.8) : 0.5 * (1.0 / 3.0 + 0.2);
  EXPECT_NEAR(drift->share.relative, (0.8 - 2.0 / 3.0) / share, 1e-12);
  EXPECT_NEAR(drift->share.limit, 2.5 * std::sqrt((1.0 - share) / share * 2.0 / 300.0), 1e-12);
}

// With 40 pieces behind the 7 left out, the windows are of 10: a share that has grown slowly for
// 20 pieces is seen, which two windows of four would let pass.
TEST(ClassDrift, LooksFurtherBackTheLongerItHasGoneOn) {
  std::vector<MixedPiece> series(47, with_classes(0.0));
  for (auto& piece : series)
    for (double& count : piece.on_liner) count *= 100.0;
  for (std::size_t i = 27; i < 47; ++i)
    series[i].on_liner[0] += 240.0 * static_cast<double>(i - 27);
  const auto drift = class_drift(of_seed_mill, series);
  ASSERT_TRUE(drift);
  EXPECT_FALSE(is_steady(drift->share));
  const auto of_last = class_drift(of_seed_mill, std::span(series).last(15));
  ASSERT_TRUE(of_last);
  EXPECT_TRUE(is_steady(of_last->share));
}

TEST(ClassDrift, OfOneClassOrOfNoneCountedIsNothing) {
  EXPECT_FALSE(class_drift(of_seed_mill, std::vector<MixedPiece>(15, {-100.0, 50.0, {300.0}})));
  EXPECT_FALSE(class_drift(of_seed_mill, std::vector<MixedPiece>(15, {-100.0, 50.0})));
  EXPECT_FALSE(class_drift(of_seed_mill, std::vector<MixedPiece>(14, with_classes(0.0))));
}

TEST(MixingState, OfTooFewPiecesIsADriftHoweverQuiet) {
  const std::vector<MixedPiece> quiet(15, {-100.0, 50.0});
  EXPECT_EQ(mixing_state(of_seed_mill, std::span(quiet).first(14)), MixingState::drifts);
  EXPECT_EQ(mixing_state(of_seed_mill, quiet), MixingState::steady);
  MixingPlan short_plan = of_seed_mill;
  short_plan.most = 14 * short_plan.piece;
  EXPECT_EQ(mixing_state(short_plan, std::span(quiet).first(14)), MixingState::at_most);
}

}  // namespace
}  // namespace millwear
