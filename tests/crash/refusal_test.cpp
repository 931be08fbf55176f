#include <gmock/gmock.h>
#include <unistd.h>

#include "orchestrator/campaign/lock_holder.h"
#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

fs::path on_path(const std::string& program) {
  std::istringstream folders(std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0)
      return fs::path(folder) / program;
  throw std::runtime_error(program + " is not on PATH");
}

class Refusal : public testing::Test {
 protected:
  TemporaryFolder folder;
  fs::path campaign = folder.path() / "run";
};

TEST_F(Refusal, OfAFolderInUseNamesWhoUsesIt) {
  MillwearProcess first(run_into(campaign));
  ASSERT_TRUE(first.wait_until([&] { return fs::exists(partial_of(campaign, "cycle_000/mix")); }));
  const Ended second = millwear(run_into(campaign));
  EXPECT_EQ(second.code, 7);
  EXPECT_THAT(second.err, AllOf(HasSubstr(campaign.string()),
                                HasSubstr("in use by process " + std::to_string(first.pid()))));
  EXPECT_EQ(millwear({"report", case_file, "--out", campaign.string()}).code, 7);
  const Ended status = millwear({"status", case_file, "--out", campaign.string()});
  EXPECT_EQ(status.code, 0);
  EXPECT_THAT(status.out, HasSubstr("running: cycle 0"));
}

TEST_F(Refusal, OfAMissingProgramNamesItsPackageAndWritesNothing) {
  for (const auto& [there, package] :
       {std::pair{"mpirun", "`liggghts`"}, std::pair{"liggghts", "`openmpi-bin`"}}) {
    const fs::path programs = folder.path() / ("with_" + std::string(there));
    fs::create_directory(programs);
    fs::create_symlink(on_path(there), programs / there);
    const Ended ended = millwear(run_into(campaign), {.path = programs.string()});
    EXPECT_EQ(ended.code, 4);
    EXPECT_THAT(ended.err, HasSubstr(package));
    EXPECT_FALSE(fs::exists(campaign));
  }
}

TEST_F(Refusal, OfABadCaseWritesNothing) {
  const fs::path bad = folder.path() / "bad.toml";
  put_text(bad, text_of(case_file) + "\nlifespan_h = 1\n");
  const Ended ended = millwear({"run", bad.string(), "--out", campaign.string()});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr(bad.string() + ":"));
  EXPECT_FALSE(fs::exists(campaign));
  EXPECT_EQ(millwear({"run", folder.path().string(), "--out", campaign.string()}).code, 3);
  EXPECT_FALSE(fs::exists(campaign));
}

TEST_F(Refusal, OfAFileInPlaceOfTheFolderSaysSo) {
  put_text(folder.path() / "file", "mine");
  for (const auto& out : {folder.path() / "file", folder.path() / "file" / "run"})
    for (const auto& verb : {"run", "mesh", "deck"}) {
      const Ended ended = millwear({verb, case_file, "--out", out.string()});
      EXPECT_EQ(ended.code, 6) << verb;
      EXPECT_THAT(ended.err, AllOf(HasSubstr(out.string()), HasSubstr("--out"))) << verb;
    }
  EXPECT_EQ(text_of(folder.path() / "file"), "mine");
}

// A result that a script sends to a full disk must not look delivered.
TEST_F(Refusal, ToLoseAResultInSilence) {
  const Ended ended = millwear({"check", case_file}, {.standard_output = "/dev/full"});
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.err, HasSubstr("standard output"));
}

class FinishedCampaign : public Refusal {
 protected:
  FinishedCampaign() { reference.copy_to(campaign); }
  const ReferenceCampaign& reference = ReferenceCampaign::get();
};

// An mpirun that cannot run anything shows that nothing is run.
TEST_F(FinishedCampaign, RunsNothingAndKeepsItsResults) {
  const fs::path programs = folder.path() / "programs";
  fs::create_directory(programs);
  fs::create_symlink("/bin/false", programs / "mpirun");
  fs::create_symlink("/bin/false", programs / "liggghts");
  const Ended ended = millwear(run_into(campaign), {.path = programs.string()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("worn out at"));
  EXPECT_EQ(text_of(campaign / "ledger.jsonl"), text_of(reference.path() / "ledger.jsonl"));
  EXPECT_EQ(text_of(campaign / "results/history.csv"),
            text_of(reference.path() / "results/history.csv"));
}

TEST_F(FinishedCampaign, GathersLostResultsAgain) {
  fs::remove_all(campaign / "results");
  expect_resumes_to_the_same(campaign);
}

TEST_F(FinishedCampaign, IsKeptFromAnotherCase) {
  std::string text = text_of(case_file);
  text.replace(text.find("threshold = 0.2"), 15, "threshold = 0.3");
  const fs::path other = folder.path() / "other.toml";
  put_text(other, text);
  for (const auto& verb : {"run", "status", "report"}) {
    const Ended ended = millwear({verb, other.string(), "--out", campaign.string()});
    EXPECT_EQ(ended.code, 3) << verb;
    EXPECT_THAT(ended.err, AllOf(HasSubstr(other.string() + ": the case differs"),
                                 HasSubstr("case.lock.toml")));
  }
  EXPECT_EQ(millwear(run_into(campaign)).code, 0);
}

// It ended in the middle of a load's steps. That load wears the liner anew, to the lower limit.
TEST_F(FinishedCampaign, GoesOnToALowerLimitAsIfThatHadBeenGivenFromTheStart) {
  std::string text = text_of(case_file);
  text.replace(text.find("plate_limit_m = 0.0070"), 22, "plate_limit_m = 0.0080");
  const fs::path higher = folder.path() / "higher.toml";
  put_text(higher, text);
  const fs::path short_run = folder.path() / "short";
  ASSERT_EQ(millwear(run_into(short_run, higher)).code, 0);
  ASSERT_LT(text_of(short_run / "results/history.csv").size(),
            text_of(reference.path() / "results/history.csv").size());
  const Ended ended = millwear(run_into(short_run));
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* const name :
       {"results/history.csv", "results/profiles.csv", "results/bins.h5", "case.lock.toml"})
    EXPECT_TRUE(text_of(short_run / name) == text_of(reference.path() / name)) << name;
  EXPECT_EQ(millwear(run_into(short_run, higher)).code, 3);
}

TEST_F(FinishedCampaign, IsNotGoneOnWithOtherRanks) {
  const Ended ended = millwear({"run", case_file, "--out", campaign.string(), "--ranks", "2"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("begun with 1 ranks"));
}

TEST_F(FinishedCampaign, NamesAFileThatWasChanged) {
  const fs::path file = campaign / "cycle_001/dem/charge.restart";
  std::string bytes = text_of(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  put_text(file, bytes);
  for (const auto& verb : {"run", "report"}) {
    const Ended ended = millwear({verb, case_file, "--out", campaign.string()});
    EXPECT_EQ(ended.code, 5) << verb;
    EXPECT_THAT(ended.err, HasSubstr(file.string() + ": was changed"));
  }
}

TEST_F(FinishedCampaign, IsKnownByItsFolderAlone) {
  const Ended by_case = millwear({"status", case_file, "--out", campaign.string()});
  const Ended by_folder = millwear({"status", campaign.string()});
  EXPECT_EQ(by_folder.code, 0) << by_folder.err;
  EXPECT_THAT(by_folder.out, AllOf(HasSubstr("finished: plate_limit"), testing::Eq(by_case.out)));
  const Ended elsewhere = millwear({"status", folder.path().string()});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_THAT(elsewhere.err, HasSubstr("neither a campaign nor a study"));
}

TEST_F(FinishedCampaign, NamesTheLineOfADamagedLedger) {
  std::string ledger = text_of(campaign / "ledger.jsonl");
  ledger[ledger.find('\n') + 1] = 'X';
  put_text(campaign / "ledger.jsonl", ledger);
  for (const auto& verb : {"run", "status", "report"}) {
    const Ended ended = millwear({verb, case_file, "--out", campaign.string()});
    EXPECT_EQ(ended.code, 5) << verb;
    EXPECT_THAT(ended.err, HasSubstr("ledger.jsonl:2: "));
  }
}

// Without care the lock file would get the number of the closed stream, and every message with it.
TEST_F(Refusal, ToWriteMessagesIntoFilesWhenStandardErrorIsClosed) {
  ReferenceCampaign::get().copy_up_to("cycle_002/wear", campaign);
  EXPECT_EQ(millwear(run_into(campaign), {.without_standard_error = true}).code, 0);
  const std::string lock = text_of(campaign / ".lock");
  const auto holder = orchestrator::lock_holder_from(lock);
  ASSERT_TRUE(holder) << lock;
  EXPECT_EQ(lock, orchestrator::written(*holder));
  expect_resumes_to_the_same(campaign);
}

}  // namespace
}  // namespace millwear::crash
