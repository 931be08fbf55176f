#include "mill/liner/curve_csv.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double to_rounding = 1e-15;

struct Header {
  std::string_view text;
  CurveFrame frame;
  double metres;  ///< of what the table gives as 215
};

class CurveHeader : public testing::TestWithParam<Header> {};

TEST_P(CurveHeader, SaysFrameAndUnit) {
  const auto& [text, frame, metres] = GetParam();
  const CurveRows curve = curve_rows(std::string(text) + "\n0;215\n", "scan.csv");
  EXPECT_EQ(curve.frame, frame);
  EXPECT_NEAR(curve.nodes.at(0).y(), metres, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Written, CurveHeader,
                         testing::Values(Header{"xi_m;eta_m", CurveFrame::master, 215.0},
                                         Header{"xi_mm;eta_mm", CurveFrame::master, 0.215},
                                         Header{"Xi [mm];Eta [mm]", CurveFrame::master, 0.215},
                                         Header{"XI_IN;ETA_IN", CurveFrame::master, 5.461},
                                         Header{"x;y", CurveFrame::own, 215.0},
                                         Header{"x (cm);y (cm)", CurveFrame::own, 2.15},
                                         Header{"\"X/mm\";\"Y/mm\"", CurveFrame::own, 0.215},
                                         Header{"x inches;y inches", CurveFrame::own, 5.461},
                                         Header{"x [ft];y [ft]", CurveFrame::own, 65.532}),
                         [](const auto& header) {
                           return "Header" + std::to_string(header.index);
                         });

TEST(CurveCsv, TakesTheUsersUnitWhereTheFileHasNone) {
  EXPECT_NEAR(curve_rows("x,y\n0,215\n", "scan.csv", LengthUnit::millimetre).nodes[0].y(), 0.215,
              to_rounding);
}

TEST(CurveCsv, KeepsTheLines) {
  EXPECT_EQ(curve_rows("# scan\nx,y\n\n0,1\n# gap\n0,2\n", "scan.csv").lines,
            (std::vector<int>{4, 6}));
}

TEST(CurveCsv, RefusesWhatItWouldHaveToGuess) {
  const auto refusal = [](std::string_view text, std::optional<LengthUnit> unit = {}) {
    try {
      static_cast<void>(curve_rows(text, "scan.csv", unit));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("it was taken");
  };
  EXPECT_THAT(refusal("xi,eta\n0,1\n"), HasSubstr("scan.csv:1: `xi` does not say its unit"));
  EXPECT_THAT(refusal("x [mm],y\n0,1\n"), HasSubstr("of `x [mm]` and `y` one names its unit"));
  EXPECT_THAT(refusal("x [yd],y [yd]\n0,1\n"), HasSubstr("`x [yd]` names no unit of length"));
  EXPECT_THAT(refusal("x [mm],y [mm]\n0,1\n", LengthUnit::inch),
              HasSubstr("`x [mm]` is in mm and --unit says in"));
  EXPECT_THAT(refusal("a,b\n0,1\n"), HasSubstr("scan.csv:1: the header names neither"));
  EXPECT_THAT(refusal(""), HasSubstr("scan.csv:1: the table is empty"));
}

TEST(CurveCsv, RefusesAFileOfItsOwnThatIsCutOff) {
  const std::string whole = "# millwear profile 1\nxi_m,eta_m\n0,0.215\n";
  EXPECT_TRUE(curve_rows(whole, "profile.csv").is_whole_pitch);
  EXPECT_THAT(
      [&] { static_cast<void>(curve_rows(whole.substr(0, whole.size() - 1), "profile.csv")); },
      ThrowsMessage<InputError>(HasSubstr("profile.csv:3: the last line does not end")));
  EXPECT_FALSE(curve_rows("xi_m,eta_m\n0,0.215", "profile.csv").is_whole_pitch);
}

// Half of a number is a number: 0.0 in place of 0.00129 puts a point of the face on the plate.
TEST(CurveCsv, RefusesALastNumberThatIsCutOff) {
  const std::string rows = "xi_m,eta_m\n0.00,0.01584\n0.01,0.01315\n0.02,0.01070\n0.03,0.00";
  EXPECT_THAT(
      [&] { static_cast<void>(curve_rows(rows, "scan.csv")); },
      ThrowsMessage<InputError>(HasSubstr("scan.csv:5: `0.00` has fewer decimals than all")));
  EXPECT_EQ(curve_rows(rows + "851", "scan.csv").nodes.size(), 4U);
  EXPECT_EQ(curve_rows(rows + "\n", "scan.csv").nodes.size(), 4U);
}

}  // namespace
}  // namespace millwear
