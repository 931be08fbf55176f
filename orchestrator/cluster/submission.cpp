#include "orchestrator/cluster/submission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/text_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/cluster/batch_script.h"
#include "orchestrator/dem_run/rank_cost.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

// An estimate of the time may be wrong by three.
constexpr double spare_time = 3.0;
constexpr double least_hours = 1.0;
constexpr double longest_hours = 24.0;
constexpr double spare_memory = 2.0;
constexpr double bytes_of_program = 512.0 * (1 << 20);

/// A word as a shell takes it; one with "$(" and a variable such as $TMPDIR stay, for the shell to
/// fill in.
std::string quoted(const std::string& word) {
  const bool is_plain =
      word.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:%+@") ==
      std::string::npos;
  if (is_plain && !word.empty()) return word;
  const bool is_variable =
      word.size() > 1 && word.front() == '$' &&
      word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789/", 1) == std::string::npos;
  if (is_variable || word.find("$(") != std::string::npos) return fmt::format("\"{}\"", word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

BatchJob job_of(const BatchWork& work, const SlurmSettings& settings,
                const std::optional<JobArray>& array) {
  std::vector<std::string> words;
  for (const auto& word : work.command) words.push_back(quoted(word));
  std::vector<std::string> options;
  for (const auto& option : settings.options) options.push_back("#SBATCH " + option);
  std::string setup;
  for (const auto& module : settings.modules) setup += fmt::format("module load {}\n", module);
  return {.name = work.name,
          .log = (work.folder / (array ? work.name + "_%a.log" : work.name + ".log")).string(),
          .tasks = array ? array->tasks : 1,
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

/// A chunk that does not end before the warning begins anew in every allocation. What a chunk takes
/// is an estimate, so only a walltime that is surely too short is refused.
void check_walltime(const BatchWork& work, const SlurmSettings& settings) {
  if (!settings.hours) return;
  const double usable = 3600.0 * *settings.hours - settings.signal_seconds;
  if (usable >= work.chunk_seconds / spare_time) return;
  throw InputError(fmt::format(
      "{}: a walltime of {:.0f} s with a warning {} s before its end leaves {:.0f} s, and a chunk "
      "takes about {:.0f} s, so the job would never go on; ask for more time or ranks, or lower "
      "[dem] `chunk_particle_steps`",
      work.name, 3600.0 * *settings.hours, settings.signal_seconds, std::max(0.0, usable),
      work.chunk_seconds));
}

}  // namespace

double memory_for(const Case& mill, int ranks) {
  return bytes_of_program + spare_memory * rank_cost(mill, ranks).memory;
}

std::string submit_work(const BatchWork& work, const Submission& how,
                        const std::optional<JobArray>& array,
                        const std::vector<std::string>& after) {
  check_walltime(work, how.settings);
  const std::string text =
      how.batch_template ? read_text_file(*how.batch_template) : std::string(slurm_template());
  const std::string file = how.batch_template ? how.batch_template->string() : "slurm.sh";
  const std::string script = batch_script(text, file, job_of(work, how.settings, array));
  if (how.action == Submission::Action::test) {
    // Another scheduler's template is of use without sbatch too.
    const bool has_test = !how.batch_template || has_sbatch();
    fmt::print("{}{}", script, has_test ? "\n" + tested(script, array) : "");
    return "";
  }
  make_folder(work.folder);
  const fs::path path = work.folder / (work.name + ".sh");
  publish(path, script);
  return submit(path, array, {after});
}

}  // namespace millwear::orchestrator
