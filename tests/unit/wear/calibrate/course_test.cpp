#include "wear/calibrate/course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "wear/band/life_band.h"

namespace millwear::wear {
namespace {

/// 100 mm to 80 mm in 100 h, then twice as fast to 40 mm at 200 h.
Course bent() { return {Eigen::Vector3d(0.0, 100.0, 200.0), Eigen::Vector3d(0.100, 0.080, 0.040)}; }

TEST(Course, IsLinearBetweenItsMomentsAndUnknownAfterThem) {
  EXPECT_DOUBLE_EQ(value_at(bent(), 0.0), 0.100);
  EXPECT_DOUBLE_EQ(value_at(bent(), 50.0), 0.090);
  EXPECT_DOUBLE_EQ(value_at(bent(), 150.0), 0.060);
  EXPECT_DOUBLE_EQ(value_at(bent(), 200.0), 0.040);
  EXPECT_TRUE(std::isnan(value_at(bent(), 200.001)));
  EXPECT_TRUE(std::isnan(value_at(bent(), -1.0)));
}

TEST(Course, TellsWhenAValueIsReached) {
  EXPECT_NEAR(time_of(bent(), 0.090), 50.0, 1e-9);
  EXPECT_NEAR(time_of(bent(), 0.060), 150.0, 1e-9);
  EXPECT_DOUBLE_EQ(time_of(bent(), 0.100), 0.0);
  EXPECT_TRUE(std::isnan(time_of(bent(), 0.039)));
}

// The mill reads 60 mm after 300 h, the course after 150 h: half the coefficient.
TEST(FactorOfACourse, OfOneReadingIsTheRatioOfTheHours) {
  const std::vector<DatedLength> one = {{300.0, 0.060, 0.002}};
  const CourseFactor fit = factor_of(bent(), one);
  EXPECT_NEAR(fit.factor, 0.5, 1e-12);
  EXPECT_EQ(fit.place, FactorPlace::inside);
}

TEST(FactorOfACourse, OfReadingsOfAKnownFactorIsFoundWhateverTheirErrors) {
  for (const double factor : {0.3, 1.0, 1.7}) {
    std::vector<DatedLength> readings;
    for (const double time : {40.0, 75.0, 110.0})
      readings.push_back({time, value_at(bent(), factor * time), 1e-5 * time});
    EXPECT_NEAR(factor_of(bent(), readings).factor, factor, 1e-12);
  }
}

// On one piece H = 100 - 0.2 f t [mm]: loss 4 mm at 10 h and 6 mm at 20 h with errors 1 and 2 mm.
// f = sum w t loss / (0.2 sum w t^2) = (40 + 30) / (0.2 (100 + 100)) = 1.75.
TEST(FactorOfACourse, WeighsReadingsByTheirErrors) {
  const std::vector<DatedLength> readings = {{10.0, 0.096, 0.001}, {20.0, 0.094, 0.002}};
  EXPECT_NEAR(factor_of(bent(), readings).factor, 1.75, 1e-12);
  EXPECT_NEAR(straight_rate(0.100, readings), 0.2e-3 * 1.75, 1e-15);
}

TEST(FactorOfACourse, ReachesTheLastLinerAndNotBeyond) {
  const std::vector<DatedLength> last = {{100.0, 0.040, 0.001}};
  EXPECT_EQ(factor_of(bent(), last).place, FactorPlace::inside);
  EXPECT_NEAR(factor_of(bent(), last).factor, 2.0, 1e-12);
  const std::vector<DatedLength> deeper = {{100.0, 0.0399, 0.001}};
  EXPECT_EQ(factor_of(bent(), deeper).place, FactorPlace::beyond);
}

TEST(FactorOfACourse, IsZeroWhereNothingWore) {
  const std::vector<DatedLength> as_new = {{100.0, 0.1005, 0.001}};
  EXPECT_EQ(factor_of(bent(), as_new).place, FactorPlace::not_worn);
  EXPECT_EQ(factor_of(bent(), as_new).factor, 0.0);
}

// The published readings of an 8 m mill [days, mm]: 215 at 0 and 88 at 213 make a line through
// 79.65, 58.19 and 37.32 at 227, 263 and 298 days.
TEST(StraightRate, OfOneReadingGoesThroughItAndTheNewLiner) {
  const std::vector<DatedLength> first = {{213.0, 88.0, 2.0}};
  const double rate = straight_rate(215.0, first);
  EXPECT_NEAR(215.0 - 227.0 * rate, 79.65, 0.005);
  EXPECT_NEAR(215.0 - 263.0 * rate, 58.19, 0.005);
  EXPECT_NEAR(215.0 - 298.0 * rate, 37.32, 0.005);
}

// Two replicates of 10 and 12 mm at 10 h, 4 and 8 mm at 14 h: 5 mm in 4 h in the mean.
TEST(MeanSpeed, IsThatOfAllReplicatesSinceAMoment) {
  Eigen::MatrixXd values(3, 2);
  values << 20.0, 20.0, 10.0, 12.0, 4.0, 8.0;
  EXPECT_DOUBLE_EQ(mean_speed({0.0, 10.0, 14.0}, values, 10.0), 1.25);
  EXPECT_DOUBLE_EQ(mean_speed({0.0, 10.0, 14.0}, values, 9.0), 1.0);
}

}  // namespace
}  // namespace millwear::wear
