#include "orchestrator/study/study_points.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <set>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/study/derived_axes.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::filesystem::path pilot =
    std::filesystem::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml";
constexpr double circumference = 2.0 * std::numbers::pi * 0.465;

Case case_of(const Study& study, std::size_t point) {
  return case_from_document(
      document_of_point(study, read_case_document(study.case_file), point_values(study)[point]));
}

TEST(StudyPoints, AProductVariesTheLastAxisFirst) {
  const Study study = study_of_case(pilot, {"mill.rows=8,10", "lifter.height_m=0.03,0.04,0.05"});
  const auto points = point_values(study);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(point_count(study), 6U);
  EXPECT_THAT(points[1].labels, ElementsAre("8", "0.04"));
  EXPECT_THAT(points[5].labels, ElementsAre("10", "0.05"));
}

TEST(StudyPoints, ZipTakesTheValuesSideBySide) {
  Study study = study_of_case(pilot, {"mill.rows=8,10", "lifter.height_m=0.03,0.04"});
  study.combine = Combine::zip;
  const auto points = point_values(study);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_THAT(points[1].labels, ElementsAre("10", "0.04"));
}

// Every part of every axis has one point.
TEST(StudyPoints, ALatinHypercubeIsEvenOverEveryAxis) {
  Study study{"s.toml", "s", pilot};
  study.combine = Combine::latin_hypercube;
  study.samples = 8;
  study.axes = {{"lifter.height_m", 1, {}, {}, 0.02, 0.06}, {"mill.rows", 2, {}, {}, 8.0, 16.0}};
  std::set<int> parts;
  for (const PointValues& point : point_values(study)) {
    const double height = std::get<double>(point.values[0].data);
    parts.insert(static_cast<int>((height - 0.02) / 0.04 * 8.0));
    EXPECT_TRUE(std::holds_alternative<std::int64_t>(point.values[1].data));
  }
  EXPECT_EQ(parts.size(), 8U);
}

TEST(StudyPoints, ReplicatesDifferInTheSeed) {
  Study study = study_of_case(pilot, {"mill.rows=8,10"});
  study.replicates = 2;
  const StudyPlan plan = plan_of(study);
  ASSERT_EQ(plan.campaigns.size(), 4U);
  EXPECT_EQ(plan.campaigns[1].point, 0U);
  EXPECT_EQ(plan.campaigns[1].seed, 2U);
  std::set<std::string> hashes;
  for (const auto& campaign : plan.campaigns) hashes.insert(campaign.hash);
  EXPECT_EQ(hashes.size(), 4U);
}

TEST(StudyPoints, TheSameCaseHasTheSameHash) {
  const auto hash_of = [](const char* axis) {
    return plan_of(study_of_case(pilot, {axis})).campaigns.front().hash;
  };
  EXPECT_EQ(hash_of("mill.rows=8"), hash_of("mill.rows=8,10"));
  EXPECT_EQ(hash_of("mill.rows=12"), hash_of("wear.bins=120"));  // what the case has anyway
}

TEST(StudyPoints, OneOfTwoWaysToGiveTheSpeedTakesTheOthersPlace) {
  const Case mill = case_of(study_of_case(pilot, {"mill.speed_rpm=30"}), 0);
  EXPECT_NEAR(mill.speed * 30.0 / std::numbers::pi, 30.0, 1e-12);
}

TEST(StudyPoints, RefusesAValueWithTheLineOfTheStudy) {
  EXPECT_THAT(failure_of<InputError>(
                  [] { static_cast<void>(plan_of(study_of_case(pilot, {"mill.rows=8,400"}))); }),
              AllOf(StartsWith(pilot.string() + ":1: the case refuses mill.rows = 400: "),
                    HasSubstr("lifters overlap")));
}

// 2.922 m around: 2.922 / 0.2 = 14.6 rows.
TEST(DerivedAxes, ASpacingChoosesTheRows) {
  EXPECT_EQ(case_of(study_of_case(pilot, {"spacing_m=0.2"}), 0).liner.sector.rows, 15);
  EXPECT_NEAR(lifter_spacing(case_of(study_of_case(pilot, {"mill.rows=15"}), 0)),
              circumference / 15.0, 1e-12);
}

TEST(DerivedAxes, ARatioChoosesRowsOrWithRowsTheHeight) {
  const Case rows = case_of(study_of_case(pilot, {"spacing_to_height=5"}), 0);
  EXPECT_EQ(rows.liner.sector.rows, 15);  // 40 mm times 5
  const Case height = case_of(study_of_case(pilot, {"spacing_to_height=5", "mill.rows=10"}), 0);
  EXPECT_NEAR(lifter_height(height.liner), circumference / 10.0 / 5.0, 1e-9);
}

// A lifter of 40 mm with faces of 20 degrees is 40 + 2 x 40 tan 20 = 69.1 mm wide at its foot.
TEST(DerivedAxes, APlateWidthLeavesOutTheFoot) {
  const double foot = 0.04 + 2.0 * 0.04 * std::tan(20.0 * std::numbers::pi / 180.0);
  const Case mill = case_of(study_of_case(pilot, {"plate_width_m=0.1"}), 0);
  EXPECT_EQ(mill.liner.sector.rows, std::lround(circumference / (0.1 + foot)));
}

TEST(DerivedAxes, RefuseWhatIsNoLength) {
  EXPECT_THAT(failure_of<InputError>(
                  [] { static_cast<void>(case_of(study_of_case(pilot, {"spacing_m=near"}), 0)); }),
              HasSubstr("no number above zero"));
}

}  // namespace
}  // namespace millwear::orchestrator
