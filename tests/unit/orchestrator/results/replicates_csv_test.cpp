#include <gmock/gmock.h>

#include <fstream>

#include "mill/base/failure.h"
#include "orchestrator/results/replicates.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

class ReplicatesCsv : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file); }
  std::vector<ReplicateRow> read(const std::string& text) const {
    std::ofstream(file, std::ios::binary) << text;
    return read_replicates_csv(file);
  }
  std::string refusal(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const ResultRejected& error) {
      return error.what();
    }
    return "not refused";
  }

  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
};

const std::vector<ReplicateRow> rows = {
    {0, 0, 0.0, Eigen::Vector3d(0.215, 0.215, 0.215), Eigen::Vector3d(0.0995, 0.0995, 0.0995)},
    {0, 1, 0.1 + 0.2, Eigen::Vector3d(0.2012344, -0.001, 0.19), Eigen::Vector3d(0.09, 0.08, 0.07)}};

const std::string head =
    "# millwear replicates 1\ncycle,step,operating_hours,lifter_height_m,plate_thickness_m\n";

TEST_F(ReplicatesCsv, HoldsAListOfEachStep) {
  EXPECT_EQ(replicates_csv(rows),
            head +
                "0,0,0,0.215000 0.215000 0.215000,0.099500 0.099500 0.099500\n"
                "0,1,0.30000000000000004,0.201234 -0.001000 0.190000,0.090000 0.080000 0.070000\n");
}

TEST_F(ReplicatesCsv, ReadsBackToAThousandthOfAMillimetre) {
  const std::string text = replicates_csv(rows);
  const auto back = read(text);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[1].step, 1);
  EXPECT_EQ(back[1].operating_hours, rows[1].operating_hours);
  EXPECT_TRUE(back[1].heights.isApprox(rows[1].heights, 5e-6));
  EXPECT_EQ(back[1].plates[2], 0.07);
  EXPECT_EQ(replicates_csv(back), text);
}

TEST_F(ReplicatesCsv, RefusesListsThatAreNotAllAsLongOrNoNumbers) {
  EXPECT_THAT(refusal(head + "0,0,0,0.2 0.2,0.1 0.1\n0,1,5,0.2 0.2,0.1\n"),
              HasSubstr(".csv:4: 2 lifter heights and 1 plate thicknesses"));
  EXPECT_THAT(refusal(head + "0,0,0,0.2 0.2,0.1 0.1\n0,1,5,0.2,0.1\n"), HasSubstr(".csv:4: "));
  EXPECT_THAT(refusal(head + "0,0,0,0.2 x,0.1 0.1\n"), HasSubstr(".csv:3: 0 lifter heights"));
  EXPECT_THAT(refusal(head + "0,0,0,,\n"), HasSubstr(".csv:3: "));
  EXPECT_THAT(refusal("# millwear replicates 2\n"), HasSubstr("this version reads"));
}

// 60 steps of 200 replicates stay small enough to be kept beside a case.
TEST_F(ReplicatesCsv, StaysBelowHalfAMegabyte) {
  const ReplicateRow row{1, 1, 1234.5678901234567, Eigen::VectorXd::Constant(200, 0.21512345),
                         Eigen::VectorXd::Constant(200, 0.0912345)};
  EXPECT_LT(replicates_csv(std::vector<ReplicateRow>(60, row)).size(), 500000u);
}

}  // namespace
}  // namespace millwear::orchestrator
