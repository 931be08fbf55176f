#include "mill/case_file/case_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"
#include "mill/case_file/case_manual.h"
#include "mill/case_keys/case_schema.h"
#include "mill/liner/profile_crossing.h"

namespace millwear {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> case_files(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(MILLWEAR_CONFIG_TESTS) / folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  return info.param.stem().string();
}

/// The lines `#> text` of a case file: what its refusal has to say.
std::vector<std::string> wanted_texts(const fs::path& file) {
  std::vector<std::string> texts;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with("#> ");) {
    texts.push_back(line.substr(3));
  }
  return texts;
}

class InvalidCase : public testing::TestWithParam<fs::path> {};

TEST_P(InvalidCase, IsRefusedWithTheWantedText) {
  const std::vector<std::string> wanted = wanted_texts(GetParam());
  ASSERT_FALSE(wanted.empty()) << "no `#> ` line says what is wanted";
  try {
    static_cast<void>(read_case(GetParam()));
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    for (const std::string& text : wanted) {
      EXPECT_THAT(error.what(), testing::HasSubstr(text));
    }
    EXPECT_EQ(error.exit_code, ExitCode::bad_case_file);
  }
}

INSTANTIATE_TEST_SUITE_P(Config, InvalidCase, testing::ValuesIn(case_files("invalid")), name_of);

class ValidCase : public testing::TestWithParam<fs::path> {};

TEST_P(ValidCase, IsReadAndItsLockedCopyToo) {
  const Case mill = read_case(GetParam());
  const std::string locked = locked_case_text(mill);
  EXPECT_EQ(locked_case_text(case_from_text(locked, "lock.toml")), locked);
  EXPECT_EQ(first_crossing(mill.liner), (std::pair<int, int>(-1, -1)));
  EXPECT_GT(totals(mill).particles, 0U);
}

INSTANTIATE_TEST_SUITE_P(Config, ValidCase, testing::ValuesIn(case_files("valid")), name_of);

TEST(Defaults, AreThoseOfTheManual) {
  const Case mill = read_case(fs::path(MILLWEAR_CONFIG_TESTS) / "valid" / "defaults_only.toml");
  EXPECT_EQ(mill.charge.porosity, 0.4);
  EXPECT_EQ(mill.dem.modulus_reduction, 100.0);
  EXPECT_EQ(mill.dem.rayleigh_fraction, 0.3);
  EXPECT_EQ(mill.dem.rolling_friction, RollingFriction::cdt);
  EXPECT_EQ(mill.dem.contact_path, ContactPath::recorder);
  EXPECT_EQ(mill.dem.sample_every_steps, 1);
  EXPECT_EQ(mill.wear.bins, 120);
  EXPECT_EQ(mill.campaign.threshold, 0.15);
  EXPECT_DOUBLE_EQ(mill.campaign.plate_limit, 0.002);
  EXPECT_FALSE(mill.dem.keep_dumps);
  EXPECT_FALSE(mill.dem.keep_events);
  EXPECT_FALSE(mill.dem.mix_until_steady);
  EXPECT_EQ(mill.dem.pair_revolutions, 0.02);
  EXPECT_EQ(mill.wear.excess_speed, 0.1);
}

TEST(Defaults, MostRevolutionsAreFourTimesTheLeast) {
  const auto folder = fs::path(MILLWEAR_CONFIG_TESTS) / "valid";
  const Case given = read_case(folder / "error_target.toml");
  ASSERT_TRUE(given.dem.error_target);
  EXPECT_EQ(given.dem.error_target->relative_error, 0.05);
  EXPECT_EQ(given.dem.error_target->most_revolutions, 3.0);
  std::string text = locked_case_text(given);
  text.erase(text.find("most_revolutions = 3"), std::string("most_revolutions = 3\n").size());
  const Case by_default = case_from_text(text, "case.toml");
  EXPECT_EQ(by_default.dem.error_target->most_revolutions, 4.0 * 0.5);
  EXPECT_FALSE(read_case(folder / "defaults_only.toml").dem.error_target);
}

// A finished campaign goes on being the case's when its owner says how to hold it against a gauge.
TEST(Gauge, IsNoPartOfWhatIsSimulated) {
  const auto folder = fs::path(MILLWEAR_CONFIG_TESTS) / "valid";
  const Case with = read_case(folder / "gauge.toml");
  EXPECT_EQ(with.gauge.calibrate_until, 5112.0);
  const Case without = read_case(folder / "defaults_only.toml");
  EXPECT_FALSE(without.gauge.calibrate_until);
  EXPECT_EQ(locked_case_text(with), locked_case_text(without));
}

TEST(Manual, IsTheOneInDocs) {
  std::ifstream stream(fs::path(MILLWEAR_DOCS) / "case_file.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_TRUE(text == case_file_manual())
      << "docs/case_file.md is out of date; print_case_file_manual > docs/case_file.md";
}

// Each key stands in one table that exists, and a default is there where one is promised.
TEST(Schema, HoldsTogether) {
  for (const KeySpec& spec : case_keys()) {
    EXPECT_NE(find_table_spec(spec.table), nullptr) << spec.table;
    EXPECT_EQ(find_key(spec.table, spec.key), &spec) << spec.key << " stands twice";
    EXPECT_EQ(spec.presence == Presence::defaulted, !spec.default_text.empty()) << spec.key;
    EXPECT_FALSE(spec.doc.empty()) << spec.key;
  }
}

}  // namespace
}  // namespace millwear
