#include "mill/liner/gauge_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_csv.h"

namespace millwear {
namespace {

constexpr LinerSector sector{0.55, 0.5, 12};
const std::string head =
    "# millwear gauge readings 1\n"
    "operating_hours,lifter_height_m,plate_thickness_m,profile_csv,error_m\n";

class GaugeTable : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("millwear_gauge_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::vector<GaugeReading> readings(const std::string& text) {
    put(gauge_table_name, text);
    return read_gauge_readings(folder_ / gauge_table_name, sector);
  }
  /// From the line number on.
  std::string refusal(const std::string& text) {
    try {
      static_cast<void>(readings(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / gauge_table_name).string().size());
    }
    return "";
  }
  void put(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }

  std::filesystem::path folder_;
};

/// A lifter `height` above a plate worn by `worn`.
LinerProfile lifter(double height, double worn = 0.0) {
  const LinerSector worn_sector{sector.shell_radius, sector.plate_radius + worn, sector.rows};
  LinerProfile profile = profile_of(worn_sector, {height + worn, 0.05, 0.3, 0.2});
  for (auto& node : profile.nodes) node.y() -= worn;
  return {sector, profile.nodes};
}

TEST_F(GaugeTable, ReadsWhatIsKnownAndLeavesTheRestOpen) {
  const auto read = readings(head + "0,0.215,,,0.001\n5112.5, 0.088 ,0.04,,0.002 # by tape\n");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].operating_hours, 0.0);
  EXPECT_EQ(read[0].lifter_height, 0.215);
  EXPECT_FALSE(read[0].plate_thickness);
  EXPECT_FALSE(read[0].profile);
  EXPECT_EQ(read[1].operating_hours, 5112.5);
  EXPECT_EQ(read[1].plate_thickness, 0.04);
  EXPECT_EQ(read[1].error, 0.002);
}

TEST_F(GaugeTable, TableWithoutReadingsIsEmpty) { EXPECT_TRUE(readings(head).empty()); }

// A lifter of 40 mm on a plate that lost 10 of its 50 mm.
TEST_F(GaugeTable, ProfileTellsItsHeightAndPlate) {
  put("scan.csv", profile_csv(lifter(0.04, 0.01)));
  const auto read = readings(head + "100,,,scan.csv,0.001\n");
  ASSERT_TRUE(read.at(0).profile);
  EXPECT_EQ(read[0].profile->nodes, lifter(0.04, 0.01).nodes);
  EXPECT_NEAR(read[0].lifter_height.value(), 0.04, 1e-9);
  EXPECT_NEAR(read[0].plate_thickness.value(), 0.04, 1e-9);
}

TEST_F(GaugeTable, GivenHeightGoesBeforeTheProfiles) {
  put("scan.csv", profile_csv(lifter(0.04)));
  EXPECT_EQ(readings(head + "100,0.039,,scan.csv,0.001\n").at(0).lifter_height, 0.039);
}

TEST_F(GaugeTable, IsWrittenAsItIsRead) {
  const std::string text = head + "0,0.215,0.0995,,0.001\n5112,,,profile_0005112h.csv,0.0015\n";
  put(gauge_table_name, text);
  EXPECT_EQ(gauge_readings_csv(read_gauge_rows(folder_ / gauge_table_name)), text);
}

TEST_F(GaugeTable, RefusesAnotherFile) {
  EXPECT_THAT(refusal("operating_hours\n"), testing::StartsWith(":1: not a table of gauge"));
  EXPECT_THAT(refusal("# millwear gauge readings 12\n" + head.substr(28)),
              testing::StartsWith(":1: not a table of gauge"));
  EXPECT_THAT(refusal("# millwear gauge readings 1\nhours,height\n"),
              testing::StartsWith(":2: the columns are not"));
  EXPECT_THAT(refusal("# millwear gauge readings 1\n"),
              testing::StartsWith(":2: the columns are not"));
  EXPECT_THROW(static_cast<void>(read_gauge_readings(folder_ / "none.csv", sector)), InputError);
}

TEST_F(GaugeTable, RefusesWhatCannotBe) {
  EXPECT_THAT(refusal(head + "-1,0.2,,,0.001\n"), testing::StartsWith(":3: a reading at -1"));
  EXPECT_THAT(refusal(head + "1,0.2,,,0\n"), testing::StartsWith(":3: a reading with an error"));
  EXPECT_THAT(refusal(head + "1,0.2,,,\n"), testing::StartsWith(":3: `` is not a number"));
  EXPECT_THAT(refusal(head + "1,,,,0.001\n"), testing::StartsWith(":3: the reading says nothing"));
  EXPECT_THAT(refusal(head + "1,88,,,0.001\n"), testing::StartsWith(":3: a lifter 88 m high"));
  EXPECT_THAT(refusal(head + "1,,-0.01,,0.001\n"), testing::StartsWith(":3: steel -10 mm thick"));
  EXPECT_THAT(refusal(head + "1,88 mm,,,0.001\n"), testing::StartsWith(":3: `88 mm` is not a"));
  EXPECT_THAT(refusal(head + "1,0.2,,0.001\n"), testing::StartsWith(":3: 4 values where"));
}

TEST_F(GaugeTable, RefusesReadingsOutOfOrder) {
  EXPECT_THAT(refusal(head + "5,0.2,,,0.001\n4,0.1,,,0.001\n"),
              testing::StartsWith(":4: a reading at 4 h after one at 5 h"));
  EXPECT_THAT(refusal(head + "5,0.2,,,0.001\n5,0.1,,,0.001\n"),
              testing::StartsWith(":4: a reading at 5 h after one at 5 h"));
}

// Errors of 3 and 4 mm make 5 mm for the difference: it may be 15 mm, and no more. The first of all
// counts, not the last alone.
TEST_F(GaugeTable, RefusesSteelThatGrows) {
  EXPECT_EQ(refusal(head + "1,0.200,,,0.003\n2,0.2149,,,0.004\n"), "");
  EXPECT_THAT(refusal(head + "1,0.200,,,0.003\n2,0.2151,,,0.004\n"),
              testing::StartsWith(":4: the lifter height grows from 200 mm at 1 h to 215.1 mm"));
  EXPECT_THAT(refusal(head + "1,,0.040,,0.001\n2,0.1,,,0.001\n3,,0.045,,0.001\n"),
              testing::StartsWith(":5: the plate thickness grows from 40 mm at 1 h"));
}

// The same crest on a plate that is 5 mm thicker over 0.17 m: 8 cm2 more. Over 0.3 m of profile,
// three errors of 0.3 mm twice make 4 cm2, and of 1 mm 13 cm2.
TEST_F(GaugeTable, RefusesAProfileOfMoreSteel) {
  put("early.csv", profile_csv(lifter(0.04, 0.01)));
  put("late.csv", profile_csv(lifter(0.04, 0.005)));
  EXPECT_THAT(refusal(head + "1,,0.04,early.csv,0.0003\n2,,0.04,late.csv,0.0003\n"),
              testing::StartsWith(":4: the steel area grows"));
  EXPECT_EQ(refusal(head + "1,,0.04,early.csv,0.001\n2,,0.04,late.csv,0.001\n"), "");
}

TEST_F(GaugeTable, NamesTheProfileThatCannotBeRead) {
  put("bad_profile.csv", "xi_m,eta_m\n0,zero\n");
  EXPECT_THAT(refusal(head + "1,,,bad_profile.csv,0.001\n"), testing::HasSubstr("is not a number"));
  put("crossed.csv",
      "xi_m,eta_m\n-0.05,0.0025063\n0.03,0.04\n0.03,0.02\n-0.03,0.04\n0.05,0.0025063\n");
  EXPECT_THAT(refusal(head + "1,,,crossed.csv,0.001\n"), testing::HasSubstr("crosses itself"));
}

}  // namespace
}  // namespace millwear
