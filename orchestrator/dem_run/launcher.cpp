#include "orchestrator/dem_run/launcher.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "mill/base/failure.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/usable_cores.h"

namespace millwear::orchestrator {
namespace {

constexpr std::string_view ranks_word = "{ranks}";
constexpr std::string_view command_word = "{command}";

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<std::string> mpirun_words(int ranks) {
  const bool has_a_core_each = ranks <= usable_cores();
  std::vector<std::string> words = {program_on_path("mpirun", "openmpi-bin").string(),
                                    "-np",
                                    std::to_string(ranks),
                                    "--bind-to",
                                    "none",
                                    "--oversubscribe",
                                    "--mca",
                                    "mpi_yield_when_idle",
                                    has_a_core_each ? "0" : "1"};
  if (::geteuid() == 0) words.push_back("--allow-run-as-root");
  return words;
}

std::vector<std::string> srun_words(int ranks) {
  return {program_on_path("srun", "slurm-client").string(), fmt::format("--ntasks={}", ranks),
          "--kill-on-bad-exit=1"};
}

[[noreturn]] void refuse(const std::string& launcher, const std::string& why) {
  throw InputError(fmt::format(
      "`launcher` = \"{}\" in [dem] {}; write \"mpirun\", \"srun\", or words such as \"mpiexec -n "
      "{{ranks}} {{command}}\"",
      launcher, why));
}

/// The template's words with the number of ranks, without its last, {command}.
std::vector<std::string> template_words(const std::string& launcher, int ranks) {
  auto words = words_of(launcher);
  if (words.size() < 2 || words.back() != command_word)
    refuse(launcher, "does not end with {command}");
  words.pop_back();
  bool names_ranks = false;
  for (std::string& word : words) {
    if (const auto place = word.find(ranks_word); place != std::string::npos) {
      word.replace(place, ranks_word.size(), std::to_string(ranks));
      names_ranks = true;
    }
    if (word.find('{') != std::string::npos || word.find('}') != std::string::npos)
      refuse(launcher,
             fmt::format("has a placeholder that is neither {{ranks}} nor the one {{command}} "
                         "at its end (`{}`)",
                         word));
  }
  if (!names_ranks) refuse(launcher, "does not say {ranks}");
  if (words.front().find('/') == std::string::npos)
    words.front() = program_on_path(words.front(), "").string();
  return words;
}

}  // namespace

std::vector<std::string> launch_words(const std::string& launcher, int ranks,
                                      const std::vector<std::string>& command) {
  auto words = launcher == "mpirun" ? mpirun_words(ranks)
               : launcher == "srun" ? srun_words(ranks)
                                    : template_words(launcher, ranks);
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

void check_started_once() {
  const char* const copies = std::getenv("SLURM_STEP_NUM_TASKS");
  const bool is_in_a_step = std::getenv("SLURM_STEP_ID") != nullptr;
  if (!is_in_a_step || copies == nullptr || std::string_view(copies) == "1") return;
  throw Failure(
      ExitCode::usage,
      fmt::format("srun has started {} copies of this program, and it starts the ranks of "
                  "its DEM itself; leave srun out, or give it --ntasks=1",
                  copies));
}

}  // namespace millwear::orchestrator
