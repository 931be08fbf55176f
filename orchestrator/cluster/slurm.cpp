#include "orchestrator/cluster/slurm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "orchestrator/process/child_process.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr const char* package = "slurm-client";
constexpr int usual_array_size = 1001;

/// What a program prints, and how it ends.
struct Printed {
  std::string text;
  int code;
};

Printed printed_by(const std::vector<std::string>& command) {
  ChildProcess child(command, fs::current_path());
  Printed printed{};
  std::array<char, 4096> piece{};
  for (;;) {
    pollfd ready{child.output(), POLLIN, 0};
    ::poll(&ready, 1, 500);
    stop_if_interrupted();
    const ssize_t length = ::read(child.output(), piece.data(), piece.size());
    if (length > 0) printed.text.append(piece.data(), static_cast<std::size_t>(length));
    if (length == 0) break;
  }
  printed.code = child.wait();
  return printed;
}

std::vector<std::string> sbatch_words(const std::optional<JobArray>& array) {
  std::vector<std::string> words = {program_on_path("sbatch", package).string()};
  if (array)
    words.push_back(fmt::format("--array=0-{}{}", array->tasks - 1,
                                array->throttle > 0 ? fmt::format("%{}", array->throttle) : ""));
  return words;
}

void check_accepted(const Printed& printed, const std::string& script) {
  if (printed.code == 0) return;
  throw ExternalProgramError(
      fmt::format("sbatch refuses {}: {}", script,
                  printed.text.substr(0, printed.text.find_last_not_of('\n') + 1)));
}

}  // namespace

std::string submit(const fs::path& script, const std::optional<JobArray>& array,
                   const AfterJobs& after) {
  auto words = sbatch_words(array);
  words.push_back("--parsable");
  if (!after.jobs.empty()) {
    words.push_back(fmt::format("--dependency=afterany:{}", fmt::join(after.jobs, ":")));
    words.push_back("--kill-on-invalid-dep=yes");
  }
  words.push_back(script.string());
  const Printed printed = printed_by(words);
  check_accepted(printed, script.string());
  return printed.text.substr(0, printed.text.find_first_of(";\n"));  // "NUMBER;CLUSTER"
}

bool has_sbatch() {
  try {
    return !program_on_path("sbatch", package).empty();
  } catch (const ExternalProgramError&) {
    return false;
  }
}

std::string tested(const std::string& script, const std::optional<JobArray>& array) {
  const fs::path file = fs::temp_directory_path() / fmt::format("millwear-{}.sh", ::getpid());
  write_file(file, script);
  auto words = sbatch_words(array);
  words.insert(words.end(), {"--test-only", file.string()});
  const Printed printed = printed_by(words);
  fs::remove(file);
  check_accepted(printed, "the script");
  return printed.text;
}

int most_array_tasks() {
  const Printed printed =
      printed_by({program_on_path("scontrol", package).string(), "show", "config"});
  const std::string key = "MaxArraySize";
  const auto place = printed.text.find(key);
  if (place == std::string::npos) return usual_array_size - 1;
  const auto value = printed.text.find_first_of("0123456789", place + key.size());
  return std::max(1, std::atoi(printed.text.c_str() + value) - 1);
}

std::map<std::string, std::string> job_states(const std::vector<std::string>& jobs) {
  std::map<std::string, std::string> states;
  if (jobs.empty()) return states;
  try {
    const Printed printed =
        printed_by({program_on_path("squeue", package).string(), "--noheader", "--array",
                    "--format=%i %T", fmt::format("--jobs={}", fmt::join(jobs, ","))});
    std::istringstream lines(printed.text);
    std::string job;
    std::string state;
    if (printed.code == 0)
      while (lines >> job >> state) states[job] = state;
  } catch (const ExternalProgramError&) {
    return states;
  }
  return states;
}

std::chrono::seconds patience_of_a_job() {
  return std::chrono::seconds(std::getenv("SLURM_JOB_ID") != nullptr ? 360 : 0);
}

}  // namespace millwear::orchestrator
