#include "orchestrator/app/command_line.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <map>
#include <vector>

#include "orchestrator/app/calibrate_verb.h"
#include "orchestrator/app/compare_verb.h"
#include "orchestrator/app/import_verb.h"
#include "orchestrator/app/run_verb.h"
#include "orchestrator/app/tune_verb.h"
#include "orchestrator/app/verbs.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

/// A verb's options from the words behind its name.
template <class Options>
Options options_from(std::vector<std::string> words) {
  CLI::App verb;
  Options options;
  add_options(verb, options);
  std::reverse(words.begin(), words.end());
  verb.parse(words);
  return options;
}

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
  std::fflush(stdout);
  std::fflush(stderr);
  return {parsed, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, TakesEveryOptionOfRun) {
  const auto run = options_from<RunOptions>(
      {"case.toml", "--out", "there", "--ranks", "4", "--json", "-q", "--dry-run", "--explain"});
  EXPECT_EQ(run.common.case_file, "case.toml");
  EXPECT_EQ(run.out, "there");
  EXPECT_EQ(run.ranks, 4);
  EXPECT_EQ(run.common.form, OutputForm::json);
  EXPECT_EQ(run.common.verbosity, Verbosity::quiet);
  EXPECT_TRUE(run.dry_run);
  EXPECT_TRUE(run.explain);
}

TEST(CommandLine, TakesEveryOptionOfCompare) {
  const auto compare = options_from<CompareOptions>({"case.toml", "--calibrate-until", "5112",
                                                     "--gauge-on", "plate", "--plot", "course.png",
                                                     "--csv", "course.csv", "--readings", "there"});
  EXPECT_EQ(compare.calibrate_until, 5112.0);
  EXPECT_EQ(compare.gauge_on, GaugeOn::plate);
  EXPECT_EQ(compare.plot, "course.png");
  EXPECT_EQ(compare.csv, "course.csv");
  EXPECT_EQ(compare.readings, "there");
  EXPECT_FALSE(options_from<CompareOptions>({"case.toml"}).calibrate_until);
}

TEST(CommandLine, TakesOneCaseOrSeveralCampaignsToCompare) {
  const auto one = options_from<CompareOptions>({"case.toml", "--profiles", "a.csv", "b.csv"});
  EXPECT_EQ(one.common.case_file, "case.toml");
  EXPECT_TRUE(one.campaigns.empty());
  EXPECT_EQ(one.compared_profiles.size(), 2u);
  const auto two = options_from<CompareOptions>({"runs/a", "runs/b", "--page", "p.html", "--json"});
  EXPECT_EQ(two.campaigns, (std::vector<std::filesystem::path>{"runs/a", "runs/b"}));
  EXPECT_EQ(two.page, "p.html");
  EXPECT_EQ(two.common.form, OutputForm::json);
}

TEST(CommandLine, TakesEveryOptionOfImport) {
  const auto import = options_from<ImportOptions>(
      {"case.toml", "scan.dxf", "--hours", "5112", "--unit", "mm", "--layer", "LINER", "--align",
       "ends", "--mirror", "--reference", "old.csv", "--error-mm", "0.5", "--plate-mm", "70",
       "--readings", "there"});
  EXPECT_EQ(import.readings, "there");
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
  EXPECT_EQ(options_from<CompareOptions>({"case.toml", "--profiles", "a.csv", "b.csv", "--json"})
                .compared_profiles,
            (std::vector<std::filesystem::path>{"a.csv", "b.csv"}));
}

TEST(CommandLine, TakesEveryOptionOfCalibrate) {
  const auto calibrate =
      options_from<CalibrateOptions>({"case.toml", "--out", "run", "--readings", "measured",
                                      "--until", "4000", "--csv", "readings.csv", "--json"});
  EXPECT_EQ(calibrate.readings, "measured");
  EXPECT_EQ(calibrate.until, 4000.0);
  EXPECT_EQ(calibrate.csv, "readings.csv");
  EXPECT_EQ(calibrate.out, "run");
  const auto bare = options_from<CalibrateOptions>({"case.toml"});
  EXPECT_FALSE(bare.readings);
  EXPECT_FALSE(bare.until);
}

TEST(CommandLine, TakesEveryOptionOfTune) {
  const auto tune =
      options_from<TuneOptions>({"case.toml", "--out", "run", "--ranks", "2", "--json"});
  EXPECT_EQ(tune.out, "run");
  EXPECT_EQ(tune.ranks, 2);
  EXPECT_EQ(tune.common.form, OutputForm::json);
}

TEST(CommandLine, HasAnActionForEveryVerb) {
  const std::map<std::string, std::vector<const char*>> needed{
      {"import", {"--hours", "1"}},
      {"new", {"--shell-diameter", "1", "--rows", "12", "--filling", "0.3"}},
      {"postprocess", {"--contacts", "c", "--particles", "p", "--timestep", "1e-5"}}};
  for (const Verb& verb : verbs()) {
    std::vector<const char*> words{verb.name, "case.toml"};
    if (const auto more = needed.find(verb.name); more != needed.end())
      words.insert(words.end(), more->second.begin(), more->second.end());
    EXPECT_TRUE(answer_to(words).parsed.action) << verb.name;
  }
}

TEST(CommandLine, ShowsExamplesWithTheHelpOfEveryVerb) {
  for (const Verb& verb : verbs())
    EXPECT_THAT(answer_to({verb.name, "--help"}).out, HasSubstr(std::string("Examples:\n  ")))
        << verb.name;
}

TEST(CommandLine, HasOneLineOfHelpForEveryVerb) {
  for (const Verb& verb : verbs()) EXPECT_LE(std::string(verb.help).size(), 80u) << verb.name;
}

TEST(CommandLine, EndsWellAfterHelpAndVersionOnStandardOutput) {
  for (const auto& words : std::vector<std::vector<const char*>>{
           {"--help"}, {"-h"}, {"run", "--help"}, {"--version"}}) {
    const Answer answer = answer_to(words);
    EXPECT_FALSE(answer.parsed.action);
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
           {"compare", "case.toml", "--calibrate-until", "-1"},
           {"compare", "case.toml", "--gauge-on", "shell"},
           {"calibrate", "case.toml", "--until", "-1"},
           {"wear", "case.toml", "--until", "4000"}}) {
    const Answer answer = answer_to(words);
    EXPECT_FALSE(answer.parsed.action);
    EXPECT_EQ(answer.parsed.exit_code, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_THAT(answer.err, HasSubstr("--help"));
  }
}

TEST(CommandLine, NamesTheVerbThatIsNearest) {
  EXPECT_EQ(answer_to({"runn", "case.toml"}).err,
            "millwear: `runn` is no verb; did you mean `run`? See `millwear --help`\n");
  EXPECT_EQ(answer_to({"xyzzyplugh"}).err,
            "millwear: `xyzzyplugh` is no verb; see `millwear --help`\n");
}

TEST(CommandLine, NamesTheOptionThatIsNearest) {
  EXPECT_EQ(answer_to({"run", "case.toml", "--rank=2"}).err,
            "millwear: `--rank` is no option of `run`; did you mean `--ranks`? "
            "See `millwear run --help`\n");
}

TEST(CommandLine, SaysWhichRanksAreAllowed) {
  EXPECT_THAT(answer_to({"run", "case.toml", "--ranks", "0"}).err,
              HasSubstr("not in range 1 to 100000"));
}

}  // namespace
}  // namespace millwear::orchestrator
