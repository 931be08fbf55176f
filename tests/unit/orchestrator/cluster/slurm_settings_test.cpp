#include "orchestrator/cluster/slurm_settings.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SlurmTable : public testing::Test {
 protected:
  SlurmSettings settings_of(const std::string& table) {
    put_text(file, "name = \"study\"\n[slurm]\n" + table);
    return slurm_settings_of(file);
  }
  std::string refusal_of(const std::string& table) {
    return failure_of<InputError>([&] { settings_of(table); });
  }

  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "study.toml";
};

TEST_F(SlurmTable, IsReadWhole) {
  const auto settings = settings_of(
      "partition = \"long\"\naccount = \"mine\"\ntime = \"1-12:30:00\"\nmemory_gb = 2.5\n"
      "modules = [\"openmpi/4.1\", \"gcc\"]\nthrottle = 20\nbundle = 5\nsignal_seconds = 60\n"
      "most_restarts = 3\n");
  EXPECT_THAT(settings.options, ElementsAre("--partition=long", "--account=mine"));
  EXPECT_EQ(settings.hours, 36.5);
  EXPECT_EQ(settings.memory, 2.5 * (1 << 30));
  EXPECT_THAT(settings.modules, ElementsAre("openmpi/4.1", "gcc"));
  EXPECT_EQ(settings.throttle, 20);
  EXPECT_EQ(settings.bundle, 5);
  EXPECT_EQ(settings.signal_seconds, 60);
  EXPECT_EQ(settings.most_restarts, 3);
}

TEST_F(SlurmTable, IsRefusedByLine) {
  EXPECT_THAT(refusal_of("time = \"soon\"\n"), HasSubstr("study.toml:3: `time` = \"soon\""));
  EXPECT_THAT(refusal_of("memory_gb = 0\n"), HasSubstr("study.toml:3: `memory_gb`"));
  EXPECT_THAT(refusal_of("modules = [\"gcc; rm -r .\"]\n"), HasSubstr("study.toml:3: `modules`"));
  EXPECT_THAT(refusal_of("partition = \"a\\n#SBATCH -N 9\"\n"),
              HasSubstr("study.toml:3: `partition` is one word"));
  EXPECT_THAT(refusal_of("bundle = 0\n"), HasSubstr("study.toml:3: "));
  EXPECT_THAT(refusal_of("queue = \"long\"\n"), HasSubstr("study.toml:3: "));
}

TEST(WalltimeHours, TakesWhatSbatchTakes) {
  EXPECT_EQ(walltime_hours("90"), 1.5);
  EXPECT_EQ(walltime_hours("30:36"), 0.51);
  EXPECT_EQ(walltime_hours("12:30:00"), 12.5);
  EXPECT_EQ(walltime_hours("2-12"), 60.0);
  EXPECT_EQ(walltime_hours("1-12:30:00"), 36.5);
  for (const char* const text : {"", "soon", "1:2:3:4", "-1", "1.5"})
    EXPECT_EQ(walltime_hours(text), std::nullopt) << text;
}

TEST(SbatchOptions, AreWordsThatBeginWithADash) {
  EXPECT_THAT(sbatch_options("--partition=long -A mine --exclusive"),
              ElementsAre("--partition=long", "-A mine", "--exclusive"));
  EXPECT_THAT(failure_of<Failure>([] { static_cast<void>(sbatch_options("long -A mine")); }),
              HasSubstr("--sbatch: `long` is no option"));
}

}  // namespace
}  // namespace millwear::orchestrator
