#include "orchestrator/cluster/submission.h"

#include <gmock/gmock.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// With an sbatch of its own on PATH, which keeps its words and says what it is told.
class Submitting : public testing::Test {
 protected:
  void SetUp() override {
    old_path_ = ::getenv("PATH");
    ::setenv("PATH", (folder.path().string() + ":" + old_path_).c_str(), 1);
  }
  void TearDown() override { ::setenv("PATH", old_path_.c_str(), 1); }

  void make_sbatch(const std::string& lines) const {
    const fs::path program = folder.path() / "sbatch";
    put_text(program,
             "#!/bin/sh\necho \"$@\" >>" + (folder.path() / "words").string() + "\n" + lines);
    ::chmod(program.c_str(), 0755);
  }

  [[nodiscard]] std::string submit(const Submission& how = {}) const {
    return submit_work(
        {"run", folder.path() / "slurm", {"millwear", "run", "it's.toml"}, 2, 3600.0, 600.0, 1e9},
        how, JobArray{3, 2}, {"11", "12"});
  }

  const TemporaryFolder folder;

 private:
  std::string old_path_;
};

TEST_F(Submitting, KeepsTheScriptAndReturnsTheNumber) {
  make_sbatch("echo '42;cluster'\n");
  EXPECT_EQ(submit(), "42");
  const std::string script = text_of(folder.path() / "slurm" / "run.sh");
  EXPECT_THAT(script, HasSubstr("millwear run 'it'\\''s.toml' &\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --time=03:00:00\n"));
  EXPECT_THAT(text_of(folder.path() / "words"),
              HasSubstr("--array=0-2%2 --parsable --dependency=afterany:11:12 "
                        "--kill-on-invalid-dep=yes"));
}

TEST_F(Submitting, TellsWhatSbatchSays) {
  make_sbatch("echo 'sbatch: error: invalid partition specified: long'; exit 1\n");
  const auto why = failure_of<ExternalProgramError>([&] { static_cast<void>(submit()); });
  EXPECT_THAT(why, HasSubstr("sbatch refuses"));
  EXPECT_THAT(why, HasSubstr("invalid partition specified: long"));
}

TEST_F(Submitting, RefusesAWalltimeInWhichNoChunkEnds) {
  make_sbatch("echo 42\n");
  Submission how;
  how.settings.hours = 7.0 / 60.0;
  how.settings.signal_seconds = 300;
  EXPECT_THAT(failure_of<InputError>([&] { static_cast<void>(submit(how)); }),
              HasSubstr("leaves 120 s, and a chunk takes about 600 s"));
  EXPECT_FALSE(fs::exists(folder.path() / "slurm"));
  how.settings.hours = 10.0 / 60.0;
  EXPECT_EQ(submit(how), "42");
}

TEST_F(Submitting, WritesNothingForATest) {
  make_sbatch("echo 'sbatch: Job 43 to start at noon'\n");
  Submission how;
  how.action = Submission::Action::test;
  EXPECT_EQ(submit(how), "");
  EXPECT_THAT(text_of(folder.path() / "words"), HasSubstr("--test-only"));
  EXPECT_FALSE(fs::exists(folder.path() / "slurm"));
}

}  // namespace
}  // namespace millwear::orchestrator
