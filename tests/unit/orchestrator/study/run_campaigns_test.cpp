#include "orchestrator/study/run_campaigns.h"

#include <gmock/gmock.h>

#include <fstream>

#include "mill/base/failure.h"
#include "orchestrator/study/job_log.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(JobShare, NeverHasMoreRanksThanCores) {
  const auto share = [](int cores, int jobs, int ranks) {
    const JobShare made = job_share(cores, jobs, ranks);
    return std::pair{made.jobs, made.ranks};
  };
  EXPECT_EQ(share(8, 0, 0), std::pair(8, 1));
  EXPECT_EQ(share(8, 2, 0), std::pair(2, 4));
  EXPECT_EQ(share(8, 0, 2), std::pair(4, 2));
  EXPECT_EQ(share(2, 16, 0), std::pair(2, 1));
  EXPECT_EQ(share(2, 0, 4), std::pair(1, 4));
}

/// A study of three campaigns in which a shell script stands for the campaign: it counts its calls.
class RunCampaigns : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path pilot = fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml";
    plan = plan_of(study_of_case(pilot, {"mill.rows=8,10,12"}));
    folders = folders_of(study, plan);
    keep_plan(study, plan, folders);
  }

  int run(const std::string& script, OnFail on_fail = OnFail::go_on,
          Failed failed = Failed::leave) {
    Progress progress(Verbosity::quiet);
    const auto command = [&](const fs::path& point, int) {
      return std::vector<std::string>{"/bin/sh", "-c", "cd " + point.string() + "\n" + script};
    };
    return run_campaigns(study, plan, folders, {2, 1, on_fail, failed, command}, progress);
  }

  std::size_t calls(std::size_t campaign) const {
    const fs::path file = folders[campaign] / "calls";
    return fs::exists(file) ? fs::file_size(file) : 0;
  }

  const std::string succeeds =
      "printf x >> calls; mkdir -p results; echo {} > results/summary.json; echo said";
  const std::string second_fails =
      "case $PWD in */0002-*) printf x >> calls; exit 4 ;; esac\n" + succeeds;
  const TemporaryFolder folder;
  const StudyFolder study{folder.path() / "study"};
  StudyPlan plan;
  std::vector<fs::path> folders;
};

TEST_F(RunCampaigns, RunsEachOnceAndNoneAgain) {
  EXPECT_EQ(run(succeeds), 0);
  EXPECT_EQ(run(succeeds), 0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(calls(i), 1U);
  EXPECT_EQ(text_of(folders[0] / "run.log"), "said\n");
  for (const auto& state : states_of(study, folders)) EXPECT_EQ(state.state, CampaignState::done);
}

TEST_F(RunCampaigns, GoesOnWithTheOthersAndLeavesWhatFailed) {
  EXPECT_EQ(run(second_fails), 1);
  EXPECT_EQ(run(succeeds), 0);
  EXPECT_EQ(calls(1), 1U);
  EXPECT_THAT(states_of(study, folders)[1].why, HasSubstr("exit code 4"));
  EXPECT_EQ(run(succeeds, OnFail::go_on, Failed::retry), 0);
  EXPECT_EQ(calls(1), 2U);
}

TEST_F(RunCampaigns, StopsAtAFailureIfToldTo) {
  EXPECT_EQ(run("exit 4", OnFail::stop), 2);  // two ran side by side
  EXPECT_EQ(calls(2), 0U);
}

TEST_F(RunCampaigns, RunsAgainWhoseResultsAreGone) {
  EXPECT_EQ(run(succeeds), 0);
  fs::remove_all(folders[2] / "results");
  EXPECT_EQ(run(succeeds), 0);
  EXPECT_EQ(calls(2), 2U);
}

// Its folder was removed, it was begun anew and killed: the job log tells of the first time only.
TEST_F(RunCampaigns, RunsAgainWhatHasResultsOfALoadAndNotOfItsEnd) {
  EXPECT_EQ(run(succeeds), 0);
  put_text(folders[1] / "results" / "summary.json", "{\"outcome\": \"go_on\"}");
  EXPECT_EQ(states_of(study, folders)[1].state, CampaignState::waiting);
  EXPECT_EQ(run(succeeds), 0);
  EXPECT_EQ(calls(1), 2U);
  EXPECT_EQ(calls(0), 1U);
}

TEST_F(RunCampaigns, WaitsForAFolderThatIsStillInUse) {
  EXPECT_EQ(run("printf x >> calls; [ $(wc -c <calls) -gt 1 ] || exit 7\n"
                "mkdir -p results; echo {} > results/summary.json"),
            0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(calls(i), 2U);
}

TEST_F(RunCampaigns, RunsAgainWhatASignalStopped) {
  EXPECT_EQ(run("kill -TERM $$"), 3);
  EXPECT_EQ(run(succeeds), 0);
  EXPECT_EQ(calls(0), 1U);
}

TEST_F(RunCampaigns, AJobLogThatWasCutOffCountsUpToThere) {
  append_job(study.jobs(), {"0001-a", "host", utc_now(), 1.5, 0, "run"});
  std::ofstream(study.jobs(), std::ios::app) << "0002-b\thost\t2026";
  const auto exits = last_exits(study.jobs());
  EXPECT_EQ(exits.size(), 1U);
  EXPECT_EQ(exits.at("0001-a"), 0);
}

TEST_F(RunCampaigns, AnotherStudyInTheFolderFindsItsPoints) {
  const fs::path pilot = fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml";
  const auto others = folders_of(study, plan_of(study_of_case(pilot, {"mill.rows=7,12"})));
  EXPECT_EQ(others[1], folders[2]);
  EXPECT_THAT(others[0].filename().string(), testing::StartsWith("0004-"));
}

TEST_F(RunCampaigns, RefusesAPointThatWasEdited) {
  std::ofstream(folders[0] / "case.toml", std::ios::app) << "# mine\n";
  EXPECT_THAT(failure_of<InputError>([&] { static_cast<void>(folders_of(study, plan)); }),
              HasSubstr("was changed by hand"));
}

TEST_F(RunCampaigns, RefusesTheFolderOfAnotherBaseCase) {
  StudyPlan other = plan;
  other.base.name = "other_mill";
  EXPECT_THAT(failure_of<InputError>([&] { keep_plan(study, other, folders); }),
              HasSubstr("belongs to a study of the case `pilot_mill`"));
}

TEST_F(RunCampaigns, LinksWhatVariesByItsValue) {
  link_by_value(study, plan, folders);
  EXPECT_TRUE(fs::equivalent(study.by_value() / "rows=10", folders[1]));
}

}  // namespace
}  // namespace millwear::orchestrator
