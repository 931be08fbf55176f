#include "orchestrator/process/usable_cores.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string>

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr int no_limit = std::numeric_limits<int>::max();

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// "200000 100000" of version 2; none for "max 100000" and for what is not there.
std::optional<double> quota_of_version_2(const fs::path& group) {
  std::ifstream stream(group / "cpu.max");
  double quota = 0.0;
  double period = 0.0;
  if (stream >> quota >> period && period > 0.0) return quota / period;
  return std::nullopt;
}

std::optional<double> quota_of_version_1(const fs::path& group) {
  std::ifstream quota_file(group / "cpu.cfs_quota_us");
  std::ifstream period_file(group / "cpu.cfs_period_us");
  double quota = 0.0;
  double period = 0.0;
  if (quota_file >> quota && period_file >> period && quota > 0.0 && period > 0.0)
    return quota / period;
  return std::nullopt;
}

/// The least quota of a group and of those above it, `mount` the highest.
template <class Quota>
double least_quota(const fs::path& mount, const fs::path& group, Quota quota_of) {
  double least = std::numeric_limits<double>::infinity();
  fs::path at = mount;
  const auto look = [&] {
    if (const auto quota = quota_of(at)) least = std::min(least, *quota);
  };
  look();
  for (const auto& part : group.relative_path()) {
    at /= part;
    look();
  }
  return least;
}

std::optional<int> whole_number(const char* text) {
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const long number = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || number < 1 || number > no_limit) return std::nullopt;
  return static_cast<int>(number);
}

}  // namespace

std::vector<int> allowed_processors() {
  constexpr int most = 1 << 16;
  cpu_set_t* const set = CPU_ALLOC(most);
  const std::size_t size = CPU_ALLOC_SIZE(most);
  std::vector<int> processors;
  if (::sched_getaffinity(0, size, set) == 0)
    for (int i = 0; i < most; ++i)
      if (CPU_ISSET_S(i, size, set)) processors.push_back(i);
  CPU_FREE(set);
  return processors;
}

int cores_behind(const std::vector<int>& processors, const fs::path& root) {
  std::set<std::string> cores;
  for (const int processor : processors) {
    const auto siblings = first_line(root / fmt::format("sys/devices/system/cpu/cpu{}/topology/"
                                                        "thread_siblings_list",
                                                        processor));
    cores.insert(siblings.empty() ? std::to_string(processor) : siblings);
  }
  return std::max(1, static_cast<int>(cores.size()));
}

int processors_by_quota(const fs::path& root) {
  double least = std::numeric_limits<double>::infinity();
  const fs::path mount = root / "sys/fs/cgroup";
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty())
      least = std::min(least, least_quota(mount, group, quota_of_version_2));
    else if (("," + controllers + ",").find(",cpu,") != std::string::npos)
      for (const char* const folder : {"cpu", "cpu,cpuacct"})
        least = std::min(least, least_quota(mount / folder, group, quota_of_version_1));
  }
  if (least >= static_cast<double>(no_limit)) return no_limit;
  return std::max(1, static_cast<int>(least));
}

int usable_cores() {
  const int cores = std::min(cores_behind(allowed_processors()), processors_by_quota());
  const bool is_in_slurm = std::getenv("SLURM_JOB_ID") != nullptr;
  const auto of_slurm =
      is_in_slurm ? whole_number(std::getenv("SLURM_CPUS_ON_NODE")) : std::nullopt;
  return std::min(cores, of_slurm.value_or(no_limit));
}

}  // namespace millwear::orchestrator
