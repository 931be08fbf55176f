#include "orchestrator/cluster/submission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mill/base/published_file.h"
#include "mill/base/text_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/cluster/batch_script.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

// An estimate of the time may be wrong by three.
constexpr double spare_time = 3.0;
constexpr double least_hours = 1.0;
constexpr double longest_hours = 24.0;
constexpr double bytes_per_particle = 4096.0;
constexpr double bytes_per_rank = 256.0 * (1 << 20);
constexpr double bytes_of_program = 512.0 * (1 << 20);

/// A word as a shell takes it; one with "$(" stays, for the shell to fill in.
std::string quoted(const std::string& word) {
  const bool is_plain =
      word.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:%+@") ==
      std::string::npos;
  if (is_plain && !word.empty()) return word;
  if (word.find("$(") != std::string::npos) return fmt::format("\"{}\"", word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

BatchJob job_of(const BatchWork& work, const SlurmSettings& settings, bool is_array) {
  std::vector<std::string> words;
  for (const auto& word : work.command) words.push_back(quoted(word));
  std::vector<std::string> options;
  for (const auto& option : settings.options) options.push_back("#SBATCH " + option);
  std::string setup;
  for (const auto& module : settings.modules) setup += fmt::format("module load {}\n", module);
  return {.name = work.name,
          .log = (work.folder / (is_array ? work.name + "_%a.log" : work.name + ".log")).string(),
          .cores = work.cores,
          .hours = settings.hours.value_or(
              std::clamp(spare_time * work.seconds / 3600.0, least_hours, longest_hours)),
          .memory = settings.memory.value_or(work.memory),
          .options = options,
          .setup = setup,
          .command = fmt::format("{}", fmt::join(words, " ")),
          .signal_seconds = settings.signal_seconds,
          .most_restarts = settings.most_restarts};
}

}  // namespace

double memory_for(const Case& mill, int ranks) {
  return bytes_of_program + bytes_per_rank * ranks +
         bytes_per_particle * static_cast<double>(totals(mill).particles);
}

std::string submit_work(const BatchWork& work, const Submission& how,
                        const std::optional<JobArray>& array,
                        const std::vector<std::string>& after) {
  const std::string text =
      how.batch_template ? read_text_file(*how.batch_template) : std::string(slurm_template());
  const std::string file = how.batch_template ? how.batch_template->string() : "slurm.sh";
  const std::string script =
      batch_script(text, file, job_of(work, how.settings, array.has_value()));
  if (how.action == Submission::Action::test) {
    fmt::print("{}\n{}", script, tested(script, array));
    return "";
  }
  make_folder(work.folder);
  const fs::path path = work.folder / (work.name + ".sh");
  publish(path, script);
  return submit(path, array, {after});
}

}  // namespace millwear::orchestrator
