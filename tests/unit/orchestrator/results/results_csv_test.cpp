#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "mill/base/failure.h"
#include "orchestrator/app/column_pages.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/wear_rates.h"

namespace millwear::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = std::numbers::pi / 180.0;

class ResultsCsv : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file); }
  void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }

  const std::filesystem::path file =
      std::filesystem::path(::testing::TempDir()) /
      (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
};

HistoryRow example_row() {
  return {.cycle = 3,
          .step = 2,
          .operating_hours = 1.0 / 3.0,
          .calendar_hours = 24.5,
          .tonnes = unknown,
          .lifter_height = 0.215,
          .face_angle = 12.5 * degree,
          .plate_thickness = 0.0995,
          .worn_volume = 1e-7,
          .worn_fraction = 0.1,
          .roughness = 0.00125,
          .power = 161250.0,
          .shoulder = 52.0 * degree,
          .toe = 221.5 * degree,
          .power_error = 1400.0,
          .shoulder_error = 0.7 * degree,
          .toe_error = unknown,
          .lifter_height_error = 0.002,
          .plate_thickness_error = 0.0005,
          .worn_volume_error = unknown,
          .airborne_share = 0.125,
          .airborne_share_error = 0.001,
          .bare_hit_power = 2500.0,
          .bare_hit_power_error = 30.5,
          .dead_zone_share = 0.18,
          .dead_zone_share_error = 0.02,
          .between_locked_share = 0.75,
          .between_locked_share_error = unknown,
          .speed = 11.4,
          .total_filling = 0.4,
          .feed_rate = 230.0};
}

template <class Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const ResultRejected& error) {
    return error.what();
  }
  return "not refused";
}

TEST_F(ResultsCsv, HistoryIsWrittenInTheUnitsOfItsColumns) {
  EXPECT_EQ(
      history_csv({example_row()}),
      "# millwear history 5\n"
      "cycle,step,operating_hours,calendar_hours,tonnes,lifter_height_m,face_angle_deg,plate_"
      "thickness_m,"
      "worn_volume_m3_per_m,worn_fraction,roughness_m,power_w,shoulder_deg,toe_deg,"
      "power_w_se,shoulder_deg_se,toe_deg_se,lifter_height_m_se,plate_thickness_m_se,"
      "worn_volume_m3_per_m_se,airborne_share,airborne_share_se,bare_hit_power_w,"
      "bare_hit_power_w_se,dead_zone_share,dead_zone_share_se,"
      "between_lifters_locked_share,between_lifters_locked_share_se,speed_rpm,total_filling,"
      "feed_rate_t_per_h\n"
      "3,2,0.3333333333333333,24.5,,0.215,12.5,0.0995,1e-07,0.1,0.00125,161250,52,221.5,1400,0.7,,"
      "0.002,0."
      "0005,,0.125,0.001,2500,30.5,0.18,0.02,0.75,,11.4,0.4,230\n");
}

TEST_F(ResultsCsv, HistoryReadsBackAsItWas) {
  write(history_csv({example_row()}));
  const auto rows = read_history_csv(file);
  ASSERT_EQ(rows.size(), 1u);
  const auto wanted = example_row();
  EXPECT_EQ(rows[0].cycle, wanted.cycle);
  EXPECT_EQ(rows[0].step, wanted.step);
  EXPECT_EQ(rows[0].operating_hours, wanted.operating_hours);
  EXPECT_TRUE(std::isnan(rows[0].tonnes));
  EXPECT_EQ(rows[0].lifter_height, wanted.lifter_height);
  EXPECT_DOUBLE_EQ(rows[0].face_angle, wanted.face_angle);
  EXPECT_EQ(rows[0].plate_thickness, wanted.plate_thickness);
  EXPECT_EQ(rows[0].worn_volume, wanted.worn_volume);
  EXPECT_EQ(rows[0].worn_fraction, wanted.worn_fraction);
  EXPECT_EQ(rows[0].power, wanted.power);
  EXPECT_DOUBLE_EQ(rows[0].shoulder, wanted.shoulder);
  EXPECT_DOUBLE_EQ(rows[0].toe, wanted.toe);
  EXPECT_EQ(rows[0].power_error, wanted.power_error);
  EXPECT_DOUBLE_EQ(rows[0].shoulder_error, wanted.shoulder_error);
  EXPECT_TRUE(std::isnan(rows[0].toe_error));
  EXPECT_EQ(rows[0].lifter_height_error, wanted.lifter_height_error);
  EXPECT_EQ(rows[0].plate_thickness_error, wanted.plate_thickness_error);
  EXPECT_TRUE(std::isnan(rows[0].worn_volume_error));
  EXPECT_EQ(rows[0].airborne_share, wanted.airborne_share);
  EXPECT_EQ(rows[0].airborne_share_error, wanted.airborne_share_error);
  EXPECT_EQ(rows[0].bare_hit_power, wanted.bare_hit_power);
  EXPECT_EQ(rows[0].bare_hit_power_error, wanted.bare_hit_power_error);
  EXPECT_EQ(rows[0].dead_zone_share, wanted.dead_zone_share);
  EXPECT_EQ(rows[0].dead_zone_share_error, wanted.dead_zone_share_error);
  EXPECT_EQ(rows[0].between_locked_share, wanted.between_locked_share);
  EXPECT_TRUE(std::isnan(rows[0].between_locked_share_error));
  EXPECT_EQ(rows[0].calendar_hours, wanted.calendar_hours);
  EXPECT_EQ(rows[0].speed, wanted.speed);
  EXPECT_EQ(rows[0].total_filling, wanted.total_filling);
  EXPECT_EQ(rows[0].feed_rate, wanted.feed_rate);
}

TEST_F(ResultsCsv, ReadingAndWritingAgainChangesNoByte) {
  std::vector<HistoryRow> rows;
  for (int i = 0; i < 2000; ++i) {
    auto row = example_row();
    row.face_angle = std::sqrt(i) * 0.037;
    row.toe = -std::cbrt(i + 0.1) * 0.111;
    row.power = 1e5 * std::sin(i);
    rows.push_back(row);
  }
  const auto text = history_csv(rows);
  write(text);
  EXPECT_EQ(history_csv(read_history_csv(file)), text);
}

TEST_F(ResultsCsv, ProfilesReadBackAsTheyWere) {
  const std::vector<ProfileRow> rows = {
      {0, 0, 0.0, {{-0.1, 1.0 / 3.0}, {0.0, 0.2}, {0.1, 1e-9}}, {0.0, 0.25, 1e-4}},
      {0, 1, 120.5, {{-0.1, 0.0}, {0.1, 0.0}}, {0.5, 0.5}}};
  write(profiles_csv(rows));
  const auto read = read_profiles_csv(file);
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(read[i].cycle, rows[i].cycle);
    EXPECT_EQ(read[i].step, rows[i].step);
    EXPECT_EQ(read[i].operating_hours, rows[i].operating_hours);
    EXPECT_EQ(read[i].nodes, rows[i].nodes);
    EXPECT_EQ(read[i].depth_error, rows[i].depth_error);
  }
}

TEST_F(ResultsCsv, AnotherVersionIsRefusedWithItsLine) {
  auto text = history_csv({example_row()});
  text.replace(text.find(" 5\n"), 3, " 2\n");
  write(text);
  EXPECT_THAT(refusal([this] { (void)read_history_csv(file); }),
              AllOf(StartsWith(file.string() + ":1: "), HasSubstr("millwear history 2"),
                    HasSubstr("millwear history 5")));
}

TEST_F(ResultsCsv, OtherColumnsAreRefusedWithTheirLine) {
  write("# millwear profiles 2\ncycle,step,node,xi_m,eta_m\n");
  EXPECT_THAT(refusal([this] { (void)read_profiles_csv(file); }),
              StartsWith(file.string() + ":2: "));
}

TEST_F(ResultsCsv, ATornRowIsRefusedWithItsLine) {
  const auto text = history_csv({example_row(), example_row()});
  write(text.substr(0, text.size() - 20));
  EXPECT_THAT(refusal([this] { (void)read_history_csv(file); }),
              StartsWith(file.string() + ":4: "));
}

TEST_F(ResultsCsv, ATextThatIsNoNumberIsRefusedWithItsColumn) {
  write(
      "# millwear profiles "
      "2\ncycle,step,operating_hours,node,xi_m,eta_m,depth_m_se\n0,0,0,0,0.1mm,0,0\n");
  EXPECT_THAT(refusal([this] { (void)read_profiles_csv(file); }),
              AllOf(StartsWith(file.string() + ":3: "), HasSubstr("`0.1mm` in column 5")));
}

TEST_F(ResultsCsv, ALostNodeIsRefused) {
  write(
      "# millwear profiles 2\ncycle,step,operating_hours,node,xi_m,eta_m,depth_m_se\n"
      "0,0,0,0,0,0,0\n0,0,0,2,0,0,0\n");
  EXPECT_THAT(refusal([this] { (void)read_profiles_csv(file); }),
              AllOf(StartsWith(file.string() + ":4: "), HasSubstr("out of order")));
}

// A row of the page may hold a value and its standard error.
TEST_F(ResultsCsv, ThePageOfFileFormatsHasTheColumnsOfEveryTable) {
  std::ifstream stream(std::filesystem::path(MILLWEAR_CASES).parent_path() /
                       "docs/file_formats.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(with_column_pages(page), page)
      << "print_result_columns docs/file_formats.md prints the page as it should be";
  EXPECT_THAT(page, HasSubstr("<!-- columns of history -->"));
  EXPECT_THAT(page, HasSubstr("| `energy_low_j` | J |"));
}

TEST_F(ResultsCsv, AMissingFileIsADiskError) {
  EXPECT_THROW((void)read_history_csv(file), DiskError);
}

TEST_F(ResultsCsv, WearRatesComeBackAsTheyWere) {
  const std::vector<WearRateRow> rows = {{0, 0, "archard", 0, 1.0 / 3.0, 1e-12 / 7.0, unknown},
                                         {2, 1, "corrosion", 119, 0.3, 3e-11, 0.0}};
  const std::string text = wear_rates_csv(rows);
  EXPECT_THAT(text, StartsWith("# millwear wear rates 1\ncycle,mechanism,bin,arc_length_m,"));
  write(text);
  const auto back = read_wear_rates_csv(file);
  EXPECT_EQ(wear_rates_csv(back), text);
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].arc_length, 1.0 / 3.0);
  EXPECT_TRUE(std::isnan(back[0].depth_rate_error));
  EXPECT_EQ(back[1].law, "corrosion");
  EXPECT_EQ(back[1].bin, 119);
  EXPECT_EQ(back[1].depth_rate, 3e-11);
  write("# millwear wear rates 2\n");
  EXPECT_THAT(refusal([&] { static_cast<void>(read_wear_rates_csv(file)); }), HasSubstr(":1:"));
}

}  // namespace
}  // namespace millwear::orchestrator
