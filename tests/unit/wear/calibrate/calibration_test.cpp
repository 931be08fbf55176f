#include "wear/calibrate/calibration.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "mill/base/failure.h"
#include "tests/support/sample_paths.h"
#include "wear/calibrate/path_prediction.h"

namespace millwear::wear {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

/// What the path with these factors loses at even dates up to `end`, in some channels.
std::vector<LossObservation> exact_readings(const WearPath& path, const Eigen::VectorXd& factors,
                                            std::size_t count, double end, double error,
                                            const std::vector<Eigen::Index>& channels) {
  std::vector<LossObservation> readings;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = end * static_cast<double>(i + 1) / static_cast<double>(count);
    for (const Eigen::Index channel : channels)
      readings.push_back({i, time, channel, loss_at(path, factors, time).lost[channel], error});
  }
  return readings;
}

template <class Expected, class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const Expected& failure) {
    return failure.what();
  }
  return "";
}

// From coefficients that are wrong by up to a thousand.
RC_GTEST_PROP(FitFactors, FindsTheFactorsOfExactReadings, ()) {
  const double scale = std::pow(10.0, *rc::gen::inRange(-30, 31) * 0.1);
  const Vector2d truth =
      scale * Vector2d(*rc::gen::inRange(1, 100) * 1e-2, *rc::gen::inRange(1, 100) * 1e-2);
  const WearPath path = two_mechanism_path();
  const double end = 0.9 * time_of_path(path, truth);
  const FactorFit fit = fit_factors(path, exact_readings(path, truth, 5, end, 0.01, {0, 1}));
  RC_ASSERT((fit.factors - truth).norm() <= 1e-6 * truth.norm());
}

// Only the first mechanism wears; readings that ask for less than none of the second get none.
TEST(FitFactors, KeepsAFactorAtZero) {
  const WearPath path = two_mechanism_path();
  auto readings = exact_readings(path, Vector2d(1.0, 0.0), 4, 1.5, 0.01, {0, 1});
  for (auto& seen : readings)
    if (seen.channel == 1) seen.lost *= 0.8;
  const FactorFit fit = fit_factors(path, readings);
  EXPECT_EQ(fit.factors[1], 0.0);
  EXPECT_NEAR(fit.factors[0], 1.0, 0.05);
}

// Two mechanisms and one number; a channel that is none; a mechanism that never wears.
TEST(FitFactors, RefusesWhatCannotBeFitted) {
  WearPath path = two_mechanism_path();
  const auto fit = [&](const std::vector<LossObservation>& readings) {
    return refusal<InputError>([&] { static_cast<void>(fit_factors(path, readings)); });
  };
  EXPECT_THAT(fit({{0, 1.0, 0, 0.1, 0.01}}),
              HasSubstr("1 measured values cannot give the coefficients of 2 mechanisms"));
  const std::vector<LossObservation> of_no_channel{{0, 1.0, 4, 0.1, 0.01}, {1, 2.0, 0, 0.1, 0.01}};
  EXPECT_THROW(static_cast<void>(fit_factors(path, of_no_channel)), std::logic_error);
  const std::vector<LossObservation> at_no_time{{0, 0.0, 0, 0.1, 0.01}, {1, 2.0, 0, 0.1, 0.01}};
  EXPECT_THROW(static_cast<void>(fit_factors(path, at_no_time)), std::logic_error);
  for (auto& piece : path.pieces) piece.start.pace[1] = piece.end.pace[1] = 0.0;
  EXPECT_THAT(fit(exact_readings(path, Vector2d(1.0, 0.0), 4, 1.5, 0.01, {0})),
              HasSubstr("mechanism number 2 wears nothing"));
}

TEST(Calibrate, RefusesReadingsWithoutWear) {
  const WearPath path = two_mechanism_path();
  EXPECT_THAT(
      refusal<ResultRejected>([&] {
        static_cast<void>(calibrate(path, {{0, 1.0, 0, -0.1, 0.01}, {1, 2.0, 0, -0.2, 0.01}}));
      }),
      HasSubstr("show no wear"));
}

// Ten heights of error e under a constant pace: L = f t, so var f = e^2 / sum t^2.
TEST(Calibrate, GivesTheErrorOfOneFactorInClosedForm) {
  const WearPath path = one_zone_path({{100.0, {1.0, 1.0}, {1.0, 1.0}}});
  const Calibration found =
      calibrate(path, exact_readings(path, Eigen::VectorXd::Ones(1), 10, 10.0, 0.3, {1}));
  EXPECT_NEAR(found.fit.factors[0], 1.0, 1e-12);
  EXPECT_NEAR(found.errors[0], 0.3 / std::sqrt(385.0), 1e-12);
  EXPECT_EQ(found.freedom, 9);
  EXPECT_EQ(found.error_scale, 1.0);
  EXPECT_TRUE(found.alike.empty());
}

// Readings of 0 and 2 beside a line of 1, three errors apart from it: chi-square 18 of 1, and the
// error grows by its root.
TEST(Calibrate, ScalesTheErrorWhereTheFitIsPoor) {
  const WearPath path = one_zone_path({{100.0, {1.0, 1.0}, {1.0, 1.0}}});
  const Calibration found =
      calibrate(path, {{0, 1.0, 1, 0.0, 1.0 / 3.0}, {1, 1.0, 1, 2.0, 1.0 / 3.0}});
  EXPECT_NEAR(found.fit.factors[0], 1.0, 1e-9);
  EXPECT_NEAR(found.fit.chi_square, 18.0, 1e-9);
  EXPECT_NEAR(found.error_scale, std::sqrt(18.0), 1e-9);
  EXPECT_NEAR(found.errors[0], 1.0, 1e-9);
}

// The two zones tell the mechanisms apart.
TEST(Calibrate, TellsApartWhatWearsOtherPlaces) {
  const WearPath path = two_mechanism_path();
  const Calibration found =
      calibrate(path, exact_readings(path, Vector2d(1.0, 0.5), 6, 1.5, 0.01, {0, 1}));
  EXPECT_TRUE(found.alike.empty());
  EXPECT_GT(found.rise_without.minCoeff(), 100.0);
  EXPECT_LT(found.condition, 10.0);
}

// A second mechanism of twice the first's rates everywhere: only f1 + 2 f2 is known. With f = (1,
// 0.5) that is 2, and what both took is what is lost.
TEST(Calibrate, SaysThatProportionalMechanismsAreTheSame) {
  WearPath path = two_mechanism_path();
  for (auto& piece : path.pieces)
    for (auto* rates : {&piece.start, &piece.end}) {
      rates->pace[1] = 2.0 * rates->pace[0];
      rates->losses.col(1) = 2.0 * rates->losses.col(0);
    }
  const auto readings = exact_readings(path, Vector2d(1.0, 0.5), 6, 1.0, 0.01, {0, 1});
  const Calibration found = calibrate(path, readings);
  EXPECT_NEAR(found.fit.factors[0] + 2.0 * found.fit.factors[1], 2.0, 1e-9);
  ASSERT_EQ(found.alike.size(), 1U);
  EXPECT_TRUE(found.alike[0].exchangeable);
  EXPECT_TRUE(std::isnan(found.alike[0].correlation));
  EXPECT_NEAR(found.alike[0].lost, readings[10].lost + readings[11].lost, 1e-9);
  EXPECT_GT(found.alike[0].error, 0.0);
  EXPECT_LT(found.alike[0].error, 0.02);
}

// Heights of error 0.3 show no difference between a rate that grows and one that falls.
TEST(Calibrate, SaysThatRoughReadingsCannotTell) {
  const WearPath path = two_mechanism_path();
  const Calibration found =
      calibrate(path, exact_readings(path, Vector2d(0.6, 0.5), 6, 1.5, 0.3, {2}));
  ASSERT_EQ(found.alike.size(), 1U);
  EXPECT_TRUE(found.alike[0].exchangeable);
}

TEST(FactorsWithoutEach, LeaveOutOneReading) {
  const WearPath path = two_mechanism_path();
  auto readings = exact_readings(path, Vector2d(1.0, 0.5), 4, 1.5, 0.01, {0, 1});
  readings[2].lost += 1.0;
  const auto factors = factors_without_each(path, readings, fit_factors(path, readings).factors);
  ASSERT_EQ(factors.size(), 4U);
  EXPECT_LT((*factors[1] - Vector2d(1.0, 0.5)).norm(), 1e-6);
  EXPECT_GT((*factors[0] - Vector2d(1.0, 0.5)).norm(), 1e-2);
  readings.resize(3);
  EXPECT_FALSE(factors_without_each(path, readings, Vector2d(1.0, 0.5))[0]);
}

// Weighted through zero: (1 x 2 / 1 + 2 x 1 / 4) / (1 / 1 + 4 / 4) = 1.25.
TEST(StraightLine, IsTheWeightedOneThroughTheOrigin) {
  const std::vector<LossObservation> readings{{0, 1.0, 1, 2.0, 1.0}, {1, 2.0, 1, 1.0, 2.0}};
  const auto line = straight_line(readings, 3);
  EXPECT_TRUE(std::isnan(line[0]));
  EXPECT_DOUBLE_EQ(line[1], 1.25);
  EXPECT_DOUBLE_EQ(straight_line(readings, 3, 0)[1], 0.5);
}

}  // namespace
}  // namespace millwear::wear
