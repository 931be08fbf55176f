#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::IsEmpty;

class Killed : public testing::Test {
 protected:
  /// Kills the campaign some time after `seen` holds; it must not have ended before.
  void kill_when(const std::function<bool()>& seen, milliseconds later = milliseconds(0)) const {
    MillwearProcess process(run_into(campaign));
    EXPECT_TRUE(process.wait_until(seen)) << process.wait().err;
    std::this_thread::sleep_for(later);
    process.send(SIGKILL);
    EXPECT_EQ(process.wait().code, 128 + SIGKILL);
    EXPECT_THAT(survivors_in(campaign), IsEmpty());
  }

  const ReferenceCampaign& reference = ReferenceCampaign::get();
  TemporaryFolder folder;
  fs::path campaign = folder.path() / "run";
};

TEST_F(Killed, AtEveryStageInTurnItEndsInTheSameResults) {
  for (const auto& stage : reference.stages()) {
    SCOPED_TRACE(stage);
    const bool is_stretch = stage.ends_with("mix") || stage.ends_with("dem");
    kill_when([&] { return fs::exists(partial_of(campaign, stage)); },
              milliseconds(is_stretch ? 100 : 0));
  }
  expect_resumes_to_the_same(campaign);
}

class KilledDuring : public Killed, public testing::WithParamInterface<StageName> {};

// A LIGGGHTS that would run for hours without a word: no broken pipe ends it either.
TEST_P(KilledDuring, ItTakesLiggghtsWithIt) {
  const StageName stage = GetParam();
  reference.copy_up_to(stage, campaign);
  const std::string path =
      put_mpirun(folder.path() / "programs",
                 "sed -i 's/^run .*/run 1000000000/; s/^thermo .*/thermo 1000000000/' deck.in\n"
                 "exec mpirun \"$@\"");
  MillwearProcess process(run_into(campaign), {.path = path});
  const fs::path log = partial_of(campaign, stage) / "liggghts.log";
  ASSERT_TRUE(process.wait_until([&] { return text_of(log).find("Step") != std::string::npos; }));
  EXPECT_EQ(processes_in(campaign).size(), 2u);
  process.send(SIGKILL);
  static_cast<void>(process.wait());
  const auto survivors = survivors_in(campaign);
  EXPECT_THAT(survivors, IsEmpty());
  for (const int pid : survivors) ::kill(pid, SIGKILL);
}

INSTANTIATE_TEST_SUITE_P(Crash, KilledDuring, testing::Values("cycle_000/mix", "cycle_000/dem"),
                         [](const auto& tested) { return tested.param.substr(10); });

// Its spool of collisions shows that a stretch is being recorded.
TEST_F(Killed, WhileItRecordsItEndsInTheSameResults) {
  const StageName stage = "cycle_001/dem";
  reference.copy_up_to(stage, campaign);
  for (const int later_ms : {0, 50, 150}) {
    SCOPED_TRACE(later_ms);
    kill_when([&] { return fs::exists(partial_of(campaign, stage) / "events.h5.rank0"); },
              milliseconds(later_ms));
  }
  expect_resumes_to_the_same(campaign);
}

// The stage is in its place but not yet in the ledger, or just so.
TEST_F(Killed, JustAsAStageIsPublishedItEndsInTheSameResults) {
  for (const auto& stage : {"cycle_000/mesh", "cycle_000/mix", "cycle_001/wear"}) {
    SCOPED_TRACE(stage);
    kill_when([&] { return fs::exists(campaign / stage); });
  }
  expect_resumes_to_the_same(campaign);
}

TEST_F(Killed, WhilePublishingItsResultsItEndsInTheSameResults) {
  reference.copy_up_to("cycle_002/wear", campaign);
  const fs::path results = campaign / "results";
  for (const auto& name : {".history.partial.csv", "history.csv", ".bins.partial.h5", "bins.h5"}) {
    SCOPED_TRACE(name);
    fs::remove_all(results);
    MillwearProcess process(run_into(campaign));
    process.wait_until([&] { return fs::exists(results / name); });
    process.send(SIGKILL);
    static_cast<void>(process.wait());
  }
  expect_resumes_to_the_same(campaign);
}

class KilledAtRandom : public Killed, public testing::WithParamInterface<unsigned> {};

TEST_P(KilledAtRandom, AndAgainItEndsInTheSameResults) {
  std::mt19937 random(GetParam());
  std::uniform_int_distribution<int> lifetime_ms(5, 1500);
  for (int attempt = 0; attempt < 3; ++attempt) {
    MillwearProcess process(run_into(campaign));
    std::this_thread::sleep_for(milliseconds(lifetime_ms(random)));
    process.send(SIGKILL);
    static_cast<void>(process.wait());
  }
  EXPECT_THAT(survivors_in(campaign), IsEmpty());
  expect_resumes_to_the_same(campaign);
}

INSTANTIATE_TEST_SUITE_P(Crash, KilledAtRandom, testing::Values(1, 2, 3));

// What died is still dying while the next one begins.
TEST_F(Killed, AndStartedAgainAtOnceItEndsInTheSameResults) {
  for (const auto& stage : {"cycle_000/mix", "cycle_000/dem"}) {
    MillwearProcess process(run_into(campaign));
    ASSERT_TRUE(process.wait_until([&] {
      return fs::exists(partial_of(campaign, stage)) && !processes_in(campaign).empty();
    }));
    process.send(SIGKILL);
    static_cast<void>(process.wait());
  }
  expect_resumes_to_the_same(campaign);
  EXPECT_THAT(survivors_in(campaign), IsEmpty());
}

struct Stop {
  int signal;
  StageName stage;
};

class Stopped : public Killed, public testing::WithParamInterface<Stop> {};

TEST_P(Stopped, ItSaysSoAndGoesOnLater) {
  const auto& [signal, stage] = GetParam();
  reference.copy_up_to(stage, campaign);
  MillwearProcess process(run_into(campaign));
  ASSERT_TRUE(process.wait_until([&] { return fs::exists(partial_of(campaign, stage)); }));
  process.send(signal);
  const Ended ended = process.wait();
  EXPECT_EQ(ended.code, 128 + signal);
  EXPECT_THAT(ended.err, HasSubstr("the same command goes on from here"));
  EXPECT_THAT(processes_in(campaign), IsEmpty());
  expect_resumes_to_the_same(campaign);
}

INSTANTIATE_TEST_SUITE_P(Crash, Stopped,
                         testing::Values(Stop{SIGINT, "cycle_001/dem"},
                                         Stop{SIGTERM, "cycle_002/dem"},
                                         Stop{SIGINT, "cycle_002/mesh"}));

struct Loss {
  std::string program;
  StageName stage;
};

class LostRank : public Killed {
 protected:
  /// A process of a stage's stretch by that name, or 0.
  [[nodiscard]] int process_named(const std::string& program) const {
    for (const int pid : processes_in(campaign))
      if (text_of("/proc/" + std::to_string(pid) + "/comm") == program + "\n") return pid;
    return 0;
  }
};

class Lost : public LostRank, public testing::WithParamInterface<Loss> {};

// A rank or mpirun itself is killed, as by a kernel short of memory.
TEST_P(Lost, IsSeenAndTheStageRunsAgain) {
  const auto& [program, stage] = GetParam();
  reference.copy_up_to(stage, campaign);
  MillwearProcess process(run_into(campaign));
  int victim = 0;
  ASSERT_TRUE(process.wait_until([&] {
    victim = process_named(program);
    return victim != 0 && !text_of(partial_of(campaign, stage) / "liggghts.log").empty();
  }));
  ::kill(victim, SIGKILL);
  const Ended ended = process.wait();
  EXPECT_EQ(ended.code, 5);
  EXPECT_THAT(ended.err, HasSubstr("liggghts.log: LIGGGHTS stopped half way"));
  expect_not_published(campaign, stage);
  EXPECT_THAT(survivors_in(campaign), IsEmpty());
  expect_resumes_to_the_same(campaign);
}

INSTANTIATE_TEST_SUITE_P(Crash, Lost,
                         testing::Values(Loss{recorder_comm, "cycle_000/mix"},
                                         Loss{recorder_comm, "cycle_002/dem"},
                                         Loss{"mpirun", "cycle_002/dem"}),
                         [](const auto& tested) { return std::to_string(tested.index); });

// A pipe that nobody reads, in the load's place, holds the recorder where it writes it.
TEST_F(LostRank, WhileItWritesTheLoadTheStageRunsAgain) {
  const StageName stage = "cycle_001/dem";
  reference.copy_up_to(stage, campaign);
  const std::string path =
      put_mpirun(folder.path() / "programs", "mkfifo .load.partial.h5\nexec mpirun \"$@\"");
  MillwearProcess process(run_into(campaign), {.path = path});
  ASSERT_TRUE(
      process.wait_until([&] { return fs::exists(partial_of(campaign, stage) / "events.h5"); }));
  ::kill(process_named(recorder_comm), SIGKILL);
  const Ended ended = process.wait();
  EXPECT_EQ(ended.code, 5);
  EXPECT_THAT(ended.err, HasSubstr("the recorder left no load.h5"));
  expect_not_published(campaign, stage);
  expect_resumes_to_the_same(campaign);
}

}  // namespace
}  // namespace millwear::crash
