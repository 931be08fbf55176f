#include "orchestrator/cluster/batch_script.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;
using testing::Not;

BatchJob job() {
  return {.name = "points_0",
          .log = "/study/slurm/points_0_%a.log",
          .tasks = 1,
          .cores = 4,
          .hours = 30.5,
          .memory = 3.0 * (1 << 30),
          .options = {"#SBATCH --partition=long", "#SBATCH -A mine"},
          .setup = "module load openmpi/4.1\n",
          .command = "millwear run case.toml",
          .signal_seconds = 120,
          .most_restarts = 7};
}

TEST(BatchScript, OfSlurmAsksForWhatTheJobNeeds) {
  const std::string script = batch_script(slurm_template(), "slurm.sh", job());
  for (const char* const line :
       {"#SBATCH --job-name=points_0\n", "#SBATCH --output=/study/slurm/points_0_%a.log\n",
        "#SBATCH --open-mode=append\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --time=30:30:00\n",
        "#SBATCH --mem=3072M\n", "#SBATCH --signal=B:USR1@120\n", "#SBATCH --partition=long\n",
        "#SBATCH -A mine\n", "\nmodule load openmpi/4.1\n", "\nmillwear run case.toml &\n",
        "-lt 7 ]"})
    EXPECT_THAT(script, HasSubstr(line));
  EXPECT_THAT(script, Not(HasSubstr("{{")));
}

TEST(BatchScript, TakesAnyTemplateWithACommand) {
  EXPECT_EQ(batch_script("#PBS -l ncpus={{cores}}\n{{command}}\n", "pbs.sh", job()),
            "#PBS -l ncpus=4\nmillwear run case.toml\n");
}

TEST(BatchScript, RefusesAPlaceholderThatIsNoneByItsLine) {
  for (const char* const text : {"a\n{{cpus}} {{command}}\n", "a\n{{cores {{command}}"}) {
    const auto why =
        failure_of<InputError>([&] { static_cast<void>(batch_script(text, "pbs.sh", job())); });
    EXPECT_THAT(why, HasSubstr("pbs.sh:2: ")) << text;
    EXPECT_THAT(why, HasSubstr("is no placeholder of a batch script; there are {{command}}"));
  }
}

TEST(BatchScript, RefusesATemplateThatWouldRunNothing) {
  EXPECT_THAT(failure_of<InputError>(
                  [] { static_cast<void>(batch_script("#PBS\n{{setup}}", "pbs.sh", job())); }),
              HasSubstr("the template has no {{command}}"));
}

}  // namespace
}  // namespace millwear::orchestrator
