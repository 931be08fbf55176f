#include "orchestrator/dem_run/launcher.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Launcher, TakesWordsWithPlaceholders) {
  EXPECT_THAT(launch_words("/opt/mpi/mpiexec -n {ranks} --hosts=node{ranks} {command}", 3,
                           {"recorder", "run"}),
              ElementsAre("/opt/mpi/mpiexec", "-n", "3", "--hosts=node3", "recorder", "run"));
  EXPECT_THAT(launch_words("mpirun -n {ranks} {command}", 3, {"recorder"}).front(),
              EndsWith("/mpirun"));
}

TEST(Launcher, RefusesWordsThatStartNothing) {
  const auto words = [](const char* launcher) {
    return [launcher] { static_cast<void>(launch_words(launcher, 2, {"recorder"})); };
  };
  EXPECT_THAT(words("mpiexec -n 2 {command}"),
              ThrowsMessage<InputError>(HasSubstr("does not say {ranks}")));
  EXPECT_THAT(words("mpiexec -n {ranks}"),
              ThrowsMessage<InputError>(HasSubstr("does not end with {command}")));
  EXPECT_THAT(words("{command}"),
              ThrowsMessage<InputError>(HasSubstr("does not end with {command}")));
  EXPECT_THAT(words("mpiexec -n {ranks} -H {host} {command}"),
              ThrowsMessage<InputError>(HasSubstr("(`{host}`)")));
  EXPECT_THAT(words("x {command} -n {ranks} {command}"),
              ThrowsMessage<InputError>(HasSubstr("(`{command}`)")));
}

// One task of many cores is one slot to Open MPI, which then refuses two ranks.
TEST(Launcher, AsksOpenMpiForSlotsWhereverItIs) {
  const auto words = launch_words("mpirun", 2, {"recorder", "run"});
  EXPECT_THAT(words.front(), EndsWith("/mpirun"));
  EXPECT_THAT(words, Contains("--oversubscribe"));
  EXPECT_EQ(words.back(), "run");
}

TEST(Launcher, LetsRanksYieldOnlyWhereTheyShareACore) {
  const auto yields = [](int ranks) {
    const auto words = launch_words("mpirun", ranks, {"recorder"});
    return *(std::find(words.begin(), words.end(), "mpi_yield_when_idle") + 1);
  };
  EXPECT_EQ(yields(1), "0");
  EXPECT_EQ(yields(100000), "1");
}

TEST(StartedOnce, RefusesTheCopiesThatSrunStarts) {
  EXPECT_NO_THROW(check_started_once());
  ::setenv("SLURM_STEP_ID", "0", 1);
  ::setenv("SLURM_STEP_NUM_TASKS", "1", 1);
  EXPECT_NO_THROW(check_started_once());
  ::setenv("SLURM_STEP_NUM_TASKS", "2", 1);
  EXPECT_THAT(check_started_once, ThrowsMessage<Failure>(HasSubstr("srun has started 2 copies")));
  ::unsetenv("SLURM_STEP_ID");
  ::unsetenv("SLURM_STEP_NUM_TASKS");
}

}  // namespace
}  // namespace millwear::orchestrator
