#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_warnings.h"

namespace millwear {
namespace {

std::filesystem::path case_of(const std::string& name) {
  return std::filesystem::path(MILLWEAR_CASES) / name / "case.toml";
}

// Table 1 as printed: 986 balls and 25,779 rocks, 0.38 m3 of solid; 5.3 % of the volume inside the
// plate at porosity 0.4 where 40 % is declared.
TEST(SeedMill, PrintedCountsDoNotMakeTheDeclaredFilling) {
  const Case mill = read_case(case_of("seed_mill_8m"));
  EXPECT_EQ(totals(mill).particles, 26765U);
  EXPECT_NEAR(totals(mill).solid_volume, 0.379, 5e-4);
  EXPECT_NEAR(filling_inside_plate(mill), 0.0528, 1e-4);
  EXPECT_THAT(warnings(mill),
              testing::Contains(testing::HasSubstr("5.3 % filling where 40.0 % is declared")));
  EXPECT_NEAR(critical_speed_fraction(mill), 0.744, 1e-3);  // 75 % in Table 1, ball size left out
}

Case cut_at_45_mm(const std::string& shell_diameter) {
  std::ifstream stream(case_of("seed_mill_8m_full"));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto replace = [&text](const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, old.size(), now);
  };
  replace("truncate_below_m = 0.022", "truncate_below_m = 0.045");
  replace("0.00, 0.00, 0.00, 0.66,", "0.00, 0.10, 0.10, 0.46,");  // as printed
  replace("shell_diameter_m = 8.00", "shell_diameter_m = " + shell_diameter);
  return case_from_text(text, "cut.toml");
}

// 40 % filling, 14.9 % balls, both distributions cut at 45 mm, porosity 0.4. Each class rounded to
// nearest inside 7.801 m gives 38,019; the 38,028 quoted for this charge is the same rounding with
// the plate's radius of 3.9005 m rounded up to 3.901 m.
TEST(SeedMill, MeasuredDistributionCutAt45MillimetresMakesThe38000) {
  EXPECT_EQ(totals(cut_at_45_mm("8.00")).particles, 38019U);
  EXPECT_EQ(totals(cut_at_45_mm("8.001")).particles, 38028U);
  EXPECT_NEAR(totals(cut_at_45_mm("8.00")).mass, 13.2e3, 50.0);
}

// Solid = 0.4 x pi 3.9005^2 x 0.25 x 0.6 = 2.867 m3; rounding 12 classes moves it by less than
// 1e-3.
TEST(SeedMill, ChargeByFillingMakesItsFilling) {
  const Case mill = read_case(case_of("seed_mill_8m_full"));
  EXPECT_NEAR(totals(mill).solid_volume, 0.4 * std::numbers::pi * 3.9005 * 3.9005 * 0.25 * 0.6,
              3e-3);
  EXPECT_NEAR(filling_inside_plate(mill), 0.4, 4e-4);
}

// The smallest steel of the printed counts, 31.5 mm, sets the step: 0.3 x 1.699e-4 s.
TEST(SeedMill, TimeStepIsASharePerPitch) {
  const Case mill = read_case(case_of("seed_mill_8m"));
  EXPECT_NEAR(shortest_rayleigh_time(mill), rayleigh_time(0.01575, 7800.0, 7.752e8, 0.29), 1e-15);
  EXPECT_LE(plan_steps(mill).time_step, 0.3 * shortest_rayleigh_time(mill));
}

}  // namespace
}  // namespace millwear
