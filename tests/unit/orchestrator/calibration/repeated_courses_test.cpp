#include "orchestrator/calibration/repeated_courses.h"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "orchestrator/calibration/repeated_comparison.h"

namespace millwear::orchestrator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A height of 50 mm that is held out at 300 h: predicted with a standard error of 1 mm, 47 mm by
/// the line.
CalibratedCourse course(double predicted, double life) {
  const Banded height{predicted, {predicted - 1.96e-3, predicted + 1.96e-3}};
  CalibratedCourse made{};
  made.until = 250.0;
  made.factor = {2.0, {1.9, 2.1}};
  made.readings = {
      {300.0, CourseUse::held_out, 0.05, 0.001, height, 0.047, std::nullopt, {0.02, {}}}};
  made.rms = std::abs(predicted - 0.05);
  made.height_limit = 0.03;
  made.life = {life, {life - 196.0, life + 196.0}};
  return made;
}

TEST(RepeatedCourses, HaveAMeanAndAScatter) {
  const auto repeats = repeated_courses(
      {course(0.052, 990.0), course(0.054, 1000.0), course(0.056, 1010.0)}, {1, 2, 3});
  const Repeated& height = repeats.readings.at(0).predicted;
  EXPECT_THAT(height.values, ElementsAre(0.052, 0.054, 0.056));
  EXPECT_NEAR(height.mean, 0.054, 1e-15);
  EXPECT_NEAR(height.scatter, 0.002, 1e-15);
  EXPECT_NEAR(height.predicted_error, 0.001, 1e-15);
  EXPECT_NEAR(repeats.life.mean, 1000.0, 1e-12);
  EXPECT_NEAR(repeats.life.scatter, 10.0, 1e-12);
  EXPECT_NEAR(repeats.life.predicted_error, 100.0, 1e-12);
}

TEST(RepeatedCourses, AreJudgedByTheirMean) {
  const auto repeats = repeated_courses({course(0.052, 1.0), course(0.044, 1.0)}, {1, 2});
  EXPECT_EQ(repeats.held_out, 1);
  EXPECT_NEAR(repeats.rms, 0.002, 1e-12);
  EXPECT_NEAR(repeats.line_rms, 0.003, 1e-12);
  EXPECT_THAT(repeated_text(repeats), HasSubstr("the mean is off by 2.0 mm (rms), each campaign by "
                                                "2.0, 6.0 mm, the straight line by 3.0 mm"));
}

TEST(RepeatedCourses, AreNotJudgedWhereOneHasEnded) {
  const auto repeats =
      repeated_courses({course(0.052, 1.0), course(std::nan(""), std::nan(""))}, {1, 2});
  EXPECT_EQ(repeats.held_out, 0);
  EXPECT_TRUE(std::isnan(repeats.life.mean));
  EXPECT_THAT(repeated_text(repeats), HasSubstr("nothing to judge by"));
  EXPECT_THAT(repeated_json(repeats), HasSubstr("\"rms_height_m\": null"));
}

TEST(RepeatedCourses, AreTwoOrMore) {
  EXPECT_THROW(static_cast<void>(repeated_courses({course(0.05, 1.0)}, {1})), std::logic_error);
}

TEST(RepeatedCourses, AsATableHaveAStandardErrorBesideTheScatter) {
  const auto repeats = repeated_courses({course(0.052, 1.0), course(0.054, 1.0)}, {1, 2});
  EXPECT_THAT(repeated_csv(repeats), HasSubstr("\n300,held out,0.05,0.053,0.00141421356"));
}

}  // namespace
}  // namespace millwear::orchestrator
