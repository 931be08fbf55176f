#pragma once
#include <filesystem>
#include <vector>

namespace millwear::orchestrator {

/// Numbers of the processors that this process may run on (sched_getaffinity).
[[nodiscard]] std::vector<int> allowed_processors();

/// Cores behind some processors: those that share a core (hyperthreads) count once. `root` is where
/// /sys stands; a processor that it does not know is a core of its own.
[[nodiscard]] int cores_behind(const std::vector<int>& processors,
                               const std::filesystem::path& root = "/");

/// Whole processors that the control groups of this process leave it, at least 1: the least quota
/// of its group and those above it (`cpu.max` of version 2, `cpu.cfs_quota_us` over
/// `cpu.cfs_period_us` of version 1). `root` is where /proc and /sys/fs/cgroup stand. The greatest
/// int where nothing limits it.
[[nodiscard]] int processors_by_quota(const std::filesystem::path& root = "/");

/// How many ranks this process can run at full speed: the cores of its affinity, within the quota
/// of its control groups and, in an allocation of Slurm, within SLURM_CPUS_ON_NODE. At least 1.
[[nodiscard]] int usable_cores();

}  // namespace millwear::orchestrator
