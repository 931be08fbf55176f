#include "orchestrator/app/command_line.h"

#include <gmock/gmock.h>

#include <vector>

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

struct Answer {
  ParsedCommandLine parsed;
  std::string out;
  std::string err;
};

Answer answer_to(std::vector<const char*> words) {
  words.insert(words.begin(), "millwear");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto parsed = parse_command_line(static_cast<int>(words.size()), words.data());
  return {parsed, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, TakesEveryOptionOfRun) {
  const auto parsed = answer_to({"run", "case.toml", "--out", "there", "--ranks", "4", "--json",
                                 "-q", "--dry-run", "--explain"})
                          .parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->verb, Verb::run);
  EXPECT_EQ(parsed.command->case_file, "case.toml");
  EXPECT_EQ(parsed.command->out, "there");
  EXPECT_EQ(parsed.command->ranks, 4);
  EXPECT_EQ(parsed.command->form, OutputForm::json);
  EXPECT_EQ(parsed.command->verbosity, Verbosity::quiet);
  EXPECT_TRUE(parsed.command->dry_run);
  EXPECT_TRUE(parsed.command->explain);
}

TEST(CommandLine, KnowsEveryVerb) {
  const std::vector<std::pair<const char*, Verb>> verbs = {
      {"check", Verb::check}, {"mesh", Verb::mesh},       {"deck", Verb::deck},
      {"run", Verb::run},     {"status", Verb::status},   {"report", Verb::report},
      {"wear", Verb::wear},   {"compare", Verb::compare}, {"calibrate", Verb::calibrate},
      {"tune", Verb::tune}};
  for (const auto& [name, verb] : verbs)
    EXPECT_EQ(answer_to({name, "case.toml"}).parsed.command->verb, verb) << name;
}

TEST(CommandLine, TakesEveryOptionOfCompare) {
  const auto parsed =
      answer_to({"compare", "case.toml", "--calibrate-until", "5112", "--gauge-on", "plate",
                 "--plot", "course.png", "--csv", "course.csv", "--readings", "there"})
          .parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->calibrate_until, 5112.0);
  EXPECT_EQ(parsed.command->gauge_on, GaugeOn::plate);
  EXPECT_EQ(parsed.command->plot, "course.png");
  EXPECT_EQ(parsed.command->csv, "course.csv");
  EXPECT_EQ(parsed.command->readings, "there");
  EXPECT_FALSE(answer_to({"compare", "case.toml"}).parsed.command->calibrate_until);
  EXPECT_EQ(answer_to({"compare", "case.toml", "--calibrate-until", "-1"}).parsed.exit_code, 2);
  EXPECT_EQ(answer_to({"compare", "case.toml", "--gauge-on", "shell"}).parsed.exit_code, 2);
}

TEST(CommandLine, TakesEveryOptionOfImport) {
  const auto parsed = answer_to({"import", "case.toml",  "scan.dxf",    "--hours",    "5112",
                                 "--unit", "mm",         "--layer",     "LINER",      "--align",
                                 "ends",   "--mirror",   "--reference", "old.csv",    "--error-mm",
                                 "0.5",    "--plate-mm", "70",          "--readings", "there"})
                          .parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->verb, Verb::import);
  EXPECT_EQ(parsed.command->readings, "there");
  const ImportOptions& import = parsed.command->import;
  EXPECT_EQ(import.curve, "scan.dxf");
  EXPECT_EQ(import.hours, 5112.0);
  EXPECT_EQ(import.unit, LengthUnit::millimetre);
  EXPECT_EQ(import.layer, "LINER");
  EXPECT_EQ(import.align, AlignmentMode::ends);
  EXPECT_TRUE(import.mirror);
  EXPECT_EQ(import.reference, "old.csv");
  EXPECT_EQ(import.error_mm, 0.5);
  EXPECT_EQ(import.plate_mm, 70.0);
}

TEST(CommandLine, TakesTwoProfilesToCompare) {
  const auto parsed =
      answer_to({"compare", "case.toml", "--profiles", "a.csv", "b.csv", "--json"}).parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->compared_profiles,
            (std::vector<std::filesystem::path>{"a.csv", "b.csv"}));
}

TEST(CommandLine, TakesEveryOptionOfCalibrate) {
  const auto parsed = answer_to({"calibrate", "case.toml", "--out", "run", "--readings", "measured",
                                 "--until", "4000", "--csv", "readings.csv", "--json"})
                          .parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->readings, "measured");
  EXPECT_EQ(parsed.command->until, 4000.0);
  EXPECT_EQ(parsed.command->csv, "readings.csv");
  EXPECT_EQ(parsed.command->out, "run");
  const auto bare = answer_to({"calibrate", "case.toml"}).parsed;
  EXPECT_FALSE(bare.command->readings);
  EXPECT_FALSE(bare.command->until);
}

TEST(CommandLine, TakesEveryOptionOfTune) {
  const auto parsed =
      answer_to({"tune", "case.toml", "--out", "run", "--ranks", "2", "--json"}).parsed;
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->out, "run");
  EXPECT_EQ(parsed.command->ranks, 2);
  EXPECT_EQ(parsed.command->form, OutputForm::json);
}

TEST(CommandLine, EndsWellAfterHelpAndVersionOnStandardOutput) {
  for (const auto& words : std::vector<std::vector<const char*>>{
           {"--help"}, {"-h"}, {"run", "--help"}, {"--version"}}) {
    const Answer answer = answer_to(words);
    EXPECT_FALSE(answer.parsed.command);
    EXPECT_EQ(answer.parsed.exit_code, 0);
    EXPECT_THAT(answer.out, HasSubstr("millwear"));
    EXPECT_EQ(answer.err, "");
  }
}

TEST(CommandLine, RefusesWrongUsageWithExitCode2OnStandardError) {
  for (const auto& words : std::vector<std::vector<const char*>>{
           {},
           {"grind", "case.toml"},
           {"run"},
           {"run", "case.toml", "--fast"},
           {"run", "case.toml", "another"},
           {"run", "case.toml", "--ranks"},
           {"run", "case.toml", "--ranks=0"},
           {"run", "case.toml", "--ranks=x"},
           {"check", "case.toml", "--dry-run"},
           {"run", "case.toml", "--out"},
           {"import", "case.toml", "scan.csv"},
           {"import", "case.toml", "--hours", "-1"},
           {"import", "case.toml", "--hours", "1", "--unit", "inch"},
           {"import", "case.toml", "--hours", "1", "--align", "well"},
           {"compare", "case.toml", "--profiles", "a.csv"},
           {"calibrate", "case.toml", "--until", "-1"},
           {"wear", "case.toml", "--until", "4000"}}) {
    const Answer answer = answer_to(words);
    EXPECT_FALSE(answer.parsed.command);
    EXPECT_EQ(answer.parsed.exit_code, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_THAT(answer.err, HasSubstr("--help"));
  }
}

TEST(CommandLine, SaysWhichRanksAreAllowed) {
  EXPECT_THAT(answer_to({"run", "case.toml", "--ranks", "0"}).err,
              HasSubstr("not in range 1 to 100000"));
}

}  // namespace
}  // namespace millwear::orchestrator
