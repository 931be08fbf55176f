#include "wear/band/liner_replicates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "wear/band/life_band.h"
#include "wear/evolve/evolution.h"
#include "wear/numerics/random_stream.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 150;

ArcCurve two_peaks(const LinerProfile& profile) {
  ArcCurve curve{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
                 Eigen::VectorXd(bins)};
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / bins;
    curve.values[i] = 1e-9 * (0.4 + std::exp(-std::pow((place - 0.58) / 0.06, 2)));
  }
  return curve;
}

/// Deviations of ten per cent, each a wave along the profile.
Eigen::MatrixXd waves(const ArcCurve& rate, Eigen::Index count) {
  const Eigen::MatrixXd amplitudes = standard_normals(2, count, 7);
  Eigen::MatrixXd deviations(bins, count);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double phase = 6.28 * 3.0 * static_cast<double>(i) / bins;
    deviations.row(i) =
        0.1 * rate.values[i] * (amplitudes.row(0) + std::cos(phase) * amplitudes.row(1));
  }
  return deviations;
}

Evolution for_a_time(const LinerProfile& profile, const ArcCurve& rate, double duration) {
  const CampaignSettings settings{.threshold = 1.0,
                                  .steps_per_cycle = 10,
                                  .height_limit = 0.0,
                                  .plate_limit = 0.0,
                                  .cycle_limit = 1,
                                  .scheme = Scheme::adaptive,
                                  .step_tolerance = 2.0,
                                  .largest_share = 10.0};
  return evolve(std::vector<TimedLoad>{{0.0, profile, rate}}, lifter_area(profile), settings,
                duration);
}

// Against wearing every replicate by itself, which differs by 0.4 % of the depth for its other
// steps.
TEST(LinerReplicates, AreWhatOtherRatesWouldHaveWorn) {
  const auto profile = square_lifter();
  const auto rate = two_peaks(profile);
  constexpr Eigen::Index count = 8;
  const Eigen::MatrixXd deviations = waves(rate, count);
  const double duration = 1e7;
  const auto predicted = for_a_time(profile, rate, duration);
  const std::vector<TimedLoad> loads{{0.0, profile, rate}};
  const UncertainLoad load{LoadInTime(loads), deviations, {}, {}};
  auto liners = same_liners(profile, bins, count);
  double time = 0.0;
  for (const auto& step : predicted.steps) {
    liners = worn(liners, load, time, step.duration, step.profile);
    time += step.duration;
  }
  const Eigen::VectorXd heights = lifter_heights(liners);
  const Eigen::VectorXd plates = plate_thicknesses(liners);
  const Eigen::VectorXd ahead = sections_ahead(liners);
  const double scatter = (heights.array() - heights.mean()).matrix().norm() / std::sqrt(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    ArcCurve other = rate;
    other.values += deviations.col(r);
    const auto real = for_a_time(profile, other, duration).steps.back().profile;
    EXPECT_NEAR(heights[r], lifter_height(real), 0.25 * scatter);
    EXPECT_NEAR(plates[r], plate_thickness(real), 0.25 * scatter);
    const double more = steel_area(predicted.steps.back().profile) - steel_area(real);
    EXPECT_NEAR(ahead[r], more, 0.05 * std::abs(more) + 1e-6);
  }
}

TEST(LinerReplicates, OfAnExactLoadAreThePrediction) {
  const auto profile = square_lifter();
  const auto rate = two_peaks(profile);
  const auto step = for_a_time(profile, rate, 2e6).steps.front();
  const std::vector<TimedLoad> loads{{0.0, profile, rate}};
  const auto liners = worn(same_liners(profile, bins, 3),
                           {LoadInTime(loads),
                            Eigen::MatrixXd::Zero(bins, 3),
                            {},
                            Eigen::VectorXd::Constant(bins, 1e-7)},
                           0.0, step.duration, step.profile);
  EXPECT_EQ(liners.deeper.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_DOUBLE_EQ(lifter_heights(liners)[1], lifter_height(step.profile));
}

TEST(LifeBand, IsTheTimeAtTheLimit) {
  const auto moment = [](double time, double first, double second) {
    return ReplicatesInTime{time, Eigen::Vector2d(first, second), Eigen::Vector2d(1.0, 1.0)};
  };
  const std::vector<ReplicatesInTime> course = {moment(0.0, 0.2, 0.2), moment(10.0, 0.15, 0.1),
                                                moment(20.0, 0.11, 0.02)};
  const Eigen::VectorXd life = lives(course, 0.06, 0.0, 10.0);
  EXPECT_DOUBLE_EQ(life[0], 20.0 + 0.05 / 0.006);
  EXPECT_DOUBLE_EQ(life[1], 10.0 + 10.0 * 0.04 / 0.08);
}

TEST(LifeBand, HoldsNinetyFivePerCent) {
  const Band band = band_of(Eigen::VectorXd::LinSpaced(1001, 0.0, 1000.0));
  EXPECT_NEAR(band.low, 25.0, 1e-9);
  EXPECT_NEAR(band.high, 975.0, 1e-9);
  EXPECT_TRUE(std::isnan(band_of(Eigen::VectorXd::Zero(1)).low));
}

}  // namespace
}  // namespace millwear::wear
