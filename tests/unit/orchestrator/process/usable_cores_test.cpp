#include "orchestrator/process/usable_cores.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
constexpr int no_limit = std::numeric_limits<int>::max();

class UsableCores : public testing::Test {
 protected:
  void put(const std::string& file, const std::string& text) const {
    fs::create_directories((folder_.path() / file).parent_path());
    put_text(folder_.path() / file, text);
  }
  [[nodiscard]] fs::path root() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(UsableCores, HyperthreadsOfOneCoreCountOnce) {
  for (int i = 0; i < 4; ++i)
    put(fmt::format("sys/devices/system/cpu/cpu{}/topology/thread_siblings_list", i),
        fmt::format("{},{}\n", i % 2, i % 2 + 2));
  EXPECT_EQ(cores_behind({0, 1, 2, 3}, root()), 2);
  EXPECT_EQ(cores_behind({0, 2}, root()), 1);
  EXPECT_EQ(cores_behind({7, 8, 9}, root()), 3) << "unknown processors";
}

// A container with two processors' time of a machine with many.
TEST_F(UsableCores, TheQuotaOfAContainerLimits) {
  put("proc/self/cgroup", "0::/\n");
  put("sys/fs/cgroup/cpu.max", "200000 100000\n");
  EXPECT_EQ(processors_by_quota(root()), 2);
  put("sys/fs/cgroup/cpu.max", "50000 100000\n");
  EXPECT_EQ(processors_by_quota(root()), 1) << "less than one";
  put("sys/fs/cgroup/cpu.max", "max 100000\n");
  EXPECT_EQ(processors_by_quota(root()), no_limit);
}

TEST_F(UsableCores, TheQuotaOfAGroupAboveLimitsToo) {
  put("proc/self/cgroup", "0::/slurm/job_7/step_0\n");
  put("sys/fs/cgroup/slurm/job_7/cpu.max", "400000 100000\n");
  put("sys/fs/cgroup/slurm/job_7/step_0/cpu.max", "max 100000\n");
  EXPECT_EQ(processors_by_quota(root()), 4);
}

TEST_F(UsableCores, GroupsOfVersionOneAreRead) {
  put("proc/self/cgroup", "9:name=systemd:/\n4:cpu,cpuacct:/docker/a\n");
  put("sys/fs/cgroup/cpu/docker/a/cpu.cfs_quota_us", "300000\n");
  put("sys/fs/cgroup/cpu/docker/a/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processors_by_quota(root()), 3);
  put("sys/fs/cgroup/cpu/docker/a/cpu.cfs_quota_us", "-1\n");
  EXPECT_EQ(processors_by_quota(root()), no_limit);
}

TEST_F(UsableCores, WithoutControlGroupsNothingLimits) {
  EXPECT_EQ(processors_by_quota(root()), no_limit);
}

TEST_F(UsableCores, OneProcessorOfAffinityIsOneCore) {
  cpu_set_t before;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(allowed_processors().front(), &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(allowed_processors().size(), 1U);
  EXPECT_EQ(usable_cores(), 1);
  ASSERT_EQ(::sched_setaffinity(0, sizeof before, &before), 0);
}

TEST_F(UsableCores, AnAllocationOfSlurmLimits) {
  ::setenv("SLURM_CPUS_ON_NODE", "1", 1);
  const int outside = usable_cores();
  EXPECT_EQ(outside, std::min(cores_behind(allowed_processors()), processors_by_quota()));
  ::setenv("SLURM_JOB_ID", "7", 1);
  EXPECT_EQ(usable_cores(), 1);
  ::setenv("SLURM_CPUS_ON_NODE", "many", 1);
  EXPECT_EQ(usable_cores(), outside);
  ::unsetenv("SLURM_JOB_ID");
  ::unsetenv("SLURM_CPUS_ON_NODE");
}

}  // namespace
}  // namespace millwear::orchestrator
