#include "orchestrator/app/compare_verb.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/replicates.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const fs::path pilot = fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml";

/// The pilot mill's lifter of 40 mm, worn by 10 mm in each of three steps of 100 h.
std::vector<HistoryRow> history(double first_loss = 0.01) {
  std::vector<HistoryRow> rows;
  for (int step = 0; step <= 3; ++step) {
    HistoryRow row{};
    row.step = step;
    row.operating_hours = 100.0 * step;
    row.lifter_height = 0.04 - 0.01 * step + (step == 1 ? 0.01 - first_loss : 0.0);
    row.plate_thickness = 0.02;
    rows.push_back(row);
  }
  return rows;
}

/// Read at 200 and 300 h: half as fast.
class CompareVerb : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder.path() / "gauge");
    put_text(folder.path() / "gauge" / "gauge_readings.csv",
             "# millwear gauge readings 1\n"
             "operating_hours,lifter_height_m,plate_thickness_m,profile_csv,error_m\n"
             "200,0.03,,,0.001\n300,0.0245,,,0.001\n");
  }

  /// The small files of a campaign, without its loads.
  void keep_results(const fs::path& results) const {
    fs::create_directories(results);
    put_text(results / "history.csv", history_csv(history()));
    put_text(folder.path() / "case.lock.toml", locked_case_text(read_case(pilot)));
  }

  void keep_replicates(const fs::path& results) const {
    std::vector<ReplicateRow> rows;
    for (const auto& row : history())
      rows.push_back({row.cycle, row.step, row.operating_hours,
                      Eigen::VectorXd::Constant(50, row.lifter_height),
                      Eigen::VectorXd::Constant(50, row.plate_thickness)});
    put_text(results / "replicates.csv", replicates_csv(rows));
  }

  CompareOptions asked() const {
    CompareOptions made;
    made.common.case_file = pilot;
    made.outs = {folder.path()};
    made.readings = folder.path() / "gauge";
    made.calibrate_until = 250.0;
    return made;
  }

  static std::string printed(const CompareOptions& asked) {
    testing::internal::CaptureStdout();
    compare_verb(asked);
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout();
  }

  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
};

TEST_F(CompareVerb, CalibratesAlongSmallFilesThatLieInTheFolderItself) {
  keep_results(folder.path());
  const std::string text = printed(asked());
  EXPECT_THAT(text, HasSubstr("times 0.5,"));
  EXPECT_THAT(text, HasSubstr("prediction off by 0.5 mm (rms), straight line by 0.5 mm"));
  EXPECT_THAT(text, HasSubstr("has no replicates.csv"));
}

TEST_F(CompareVerb, CalibratesAlongTheResultsOfACampaign) {
  keep_results(folder.path() / "results");
  keep_replicates(folder.path() / "results");
  CompareOptions with_files = asked();
  with_files.common.form = OutputForm::json;
  with_files.csv = elsewhere.path() / "course.csv";
  const std::string json = printed(with_files);
  EXPECT_THAT(json, HasSubstr("\"calibrated_until_hours\": 250.0"));
  EXPECT_THAT(json, Not(HasSubstr("replicates.csv")));
  EXPECT_THAT(text_of(*with_files.csv),
              testing::StartsWith("# millwear calibrated comparison 1\noperating_hours,use,"));
  EXPECT_THAT(text_of(*with_files.csv), HasSubstr("\n300,held out,0.0245,0.001,0.025,0.02"));
}

/// Folders of campaigns that lost 10 and 8 mm in the first step, and the same later.
class CompareRepeats : public CompareVerb {
 protected:
  void keep_campaign(const fs::path& root, double first_loss, int seed) const {
    fs::create_directories(root);
    put_text(root / "history.csv", history_csv(history(first_loss)));
    Case run = read_case(pilot);
    run.dem.seed = seed;
    put_text(root / "case.lock.toml", locked_case_text(run));
  }
  [[nodiscard]] CompareOptions asked_for_both() const {
    CompareOptions made = asked();
    made.outs = {first, second};
    return made;
  }
  const fs::path first = folder.path() / "seed_1";
  const fs::path second = folder.path() / "seed_2";
};

// 10 mm at 200 h are lost after 100 and 110 h of the campaigns: factors 0.5 and 0.6; at 300 h they
// have 40 - 15 and 40 - 18 + ... mm.
TEST_F(CompareRepeats, ShowsTheirMeanAndScatter) {
  keep_campaign(first, 0.01, 1);
  keep_campaign(second, 0.008, 2);
  const std::string text = printed(asked_for_both());
  EXPECT_THAT(text, HasSubstr("2 campaigns, seeds 1, 2, each calibrated"));
  EXPECT_THAT(text, HasSubstr("the straight line by 0.5 mm"));
  EXPECT_THAT(text, HasSubstr("seed 1"));
}

TEST_F(CompareRepeats, RefusesTheSameSeedTwice) {
  keep_campaign(first, 0.01, 1);
  keep_campaign(second, 0.008, 1);
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(asked_for_both()); }),
              HasSubstr("both campaigns have seed 1"));
}

TEST_F(CompareRepeats, RefusesCampaignsThatDifferInMore) {
  keep_campaign(first, 0.01, 1);
  keep_campaign(second, 0.008, 2);
  Case other = read_case(pilot);
  other.dem.seed = 2;
  other.dem.settle_pitches += 1;
  put_text(second / "case.lock.toml", locked_case_text(other));
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(asked_for_both()); }),
              HasSubstr("besides the seed it differs in [dem] `settle_pitches`"));
}

TEST_F(CompareRepeats, RefusesThemWithoutACalibration) {
  CompareOptions as_run = asked_for_both();
  as_run.calibrate_until = 0.0;
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(as_run); }), HasSubstr("or name one"));
}

TEST_F(CompareVerb, DrawsAPicture) {
  keep_results(folder.path());
  CompareOptions drawing = asked();
  drawing.plot = elsewhere.path() / "course.png";
  printed(drawing);
  EXPECT_THAT(text_of(*drawing.plot), testing::StartsWith("\x89PNG"));
}

TEST_F(CompareVerb, ComparesAsRunWhereNothingSaysHowFarToCalibrate) {
  keep_results(folder.path());
  put_text(folder.path() / "profiles.csv", profiles_csv({}));
  CompareOptions as_run = asked();
  as_run.calibrate_until = 0.0;
  EXPECT_THAT(printed(as_run), HasSubstr("Heights differ by"));
}

TEST_F(CompareVerb, RefusesOptionsOfACalibrationThatIsNotAskedFor) {
  keep_results(folder.path());
  CompareOptions without = asked();
  without.calibrate_until.reset();
  without.gauge_on = GaugeOn::plate;
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(without); }),
              HasSubstr("add --calibrate-until HOURS"));
  CompareOptions profiles = asked();
  profiles.compared_profiles = {"a.csv", "b.csv"};
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(profiles); }), HasSubstr("leave"));
}

TEST_F(CompareVerb, RefusesAFolderWithoutResultsAndWritesNothing) {
  CompareOptions wanted = asked();
  wanted.csv = elsewhere.path() / "course.csv";
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(wanted); }),
              HasSubstr("no campaign with results is here"));
  keep_results(folder.path());
  wanted.calibrate_until = 100.0;
  EXPECT_THAT(failure_of<Failure>([&] { compare_verb(wanted); }),
              HasSubstr("the first is of 200 h"));
  EXPECT_FALSE(fs::exists(*wanted.csv));
}

TEST_F(CompareVerb, DoesNotWriteAmongTheCampaignsOwnFiles) {
  keep_results(folder.path() / "results");
  for (const char* const name : {"results/history.csv", "results/new.csv", "case.lock.toml"}) {
    const std::string before =
        fs::exists(folder.path() / name) ? text_of(folder.path() / name) : "";
    CompareOptions table = asked();
    table.csv = folder.path() / name;
    EXPECT_THAT(failure_of<Failure>([&] { compare_verb(table); }),
                HasSubstr("among the campaign's own files"));
    CompareOptions picture = asked();
    picture.plot = folder.path() / name;
    EXPECT_THAT(failure_of<Failure>([&] { compare_verb(picture); }),
                HasSubstr("among the campaign's own files"));
    EXPECT_EQ(fs::exists(folder.path() / name) ? text_of(folder.path() / name) : "", before);
  }
}

/// Two folders of campaigns that have begun.
class CompareFolders : public testing::Test {
 protected:
  fs::path begun(const std::string& name) const {
    const fs::path root = folder.path() / name;
    fs::create_directories(root);
    put_text(root / "case.lock.toml", locked_case_text(read_case(pilot)));
    write_ledger(root / "ledger.jsonl", {{"millwear", "hash", 2, "host"}, {}});
    return root;
  }

  CompareOptions asked(std::vector<fs::path> folders) const {
    CompareOptions made;
    made.campaigns = std::move(folders);
    made.page = folder.path() / "page.html";
    return made;
  }

  static ExitCode refused(const CompareOptions& asked) {
    try {
      compare_verb(asked);
    } catch (const Failure& failure) {
      return failure.exit_code;
    }
    return ExitCode::ok;
  }

  const TemporaryFolder folder;
};

TEST_F(CompareFolders, WriteAPageAndNothingElse) {
  const auto options = asked({begun("one"), begun("two")});
  EXPECT_EQ(refused(options), ExitCode::ok);
  EXPECT_THAT(text_of(*options.page), HasSubstr("<h1>one, two</h1>"));
  for (const auto& campaign : options.campaigns)
    EXPECT_EQ(std::distance(fs::directory_iterator(campaign), {}), 2);
}

TEST_F(CompareFolders, WriteNothingWhereOneIsNoCampaign) {
  fs::create_directory(folder.path() / "none");
  const auto options = asked({begun("one"), folder.path() / "none"});
  EXPECT_EQ(refused(options), ExitCode::bad_case_file);
  EXPECT_FALSE(fs::exists(*options.page));
}

TEST_F(CompareFolders, GoWithTheirOwnOptionsAlone) {
  auto with_csv = asked({begun("one"), begun("two")});
  with_csv.csv = folder.path() / "table.csv";
  EXPECT_EQ(refused(with_csv), ExitCode::usage);
  CompareOptions without;
  without.common.case_file = pilot;
  without.page = folder.path() / "page.html";
  EXPECT_EQ(refused(without), ExitCode::usage);
  auto inside = asked({begun("one"), begun("three")});
  inside.page = folder.path() / "one" / "page.html";
  EXPECT_EQ(refused(inside), ExitCode::usage);
  EXPECT_EQ(refused(asked(std::vector<fs::path>(9, folder.path() / "one"))), ExitCode::usage);
}

}  // namespace
}  // namespace millwear::orchestrator
