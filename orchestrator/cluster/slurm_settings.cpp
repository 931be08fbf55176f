#include "orchestrator/cluster/slurm_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/study/study_values.h"

namespace millwear::orchestrator {
namespace {

constexpr std::array<std::string_view, 10> keys{
    "signal_seconds", "partition", "account",  "constraint", "time",
    "memory_gb",      "modules",   "throttle", "bundle",     "most_restarts"};
constexpr const char* module_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+@:";
constexpr double bytes_of_gb = 1 << 30;
constexpr std::int64_t most_tasks = 1000000;

std::optional<long> whole(std::string_view text) {
  long number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

std::vector<std::string> modules_in(const CaseTable& table, CaseProblems& problems) {
  std::vector<std::string> modules;
  const CaseValue* const value = table.find("modules");
  if (value == nullptr) return modules;
  const auto* const array = std::get_if<CaseArray>(&value->data);
  if (array != nullptr)
    for (const CaseValue& element : *array)
      if (const auto* const name = std::get_if<std::string>(&element.data))
        modules.push_back(*name);
  const bool are_names = std::ranges::all_of(modules, [](const auto& name) {
    return name.find_first_not_of(module_letters) == name.npos;
  });
  if (array == nullptr || modules.size() != array->size() || !are_names)
    problems.add(value->line, "`modules` is a list of names, such as [\"openmpi/4.1\"]");
  return modules;
}

}  // namespace

std::optional<double> walltime_hours(const std::string& text) {
  std::string rest = text;
  double days = 0.0;
  const auto dash = rest.find('-');
  if (dash != std::string::npos) {
    const auto number = whole(rest.substr(0, dash));
    if (!number) return std::nullopt;
    days = static_cast<double>(*number);
    rest.erase(0, dash + 1);
  }
  std::vector<double> parts;
  std::istringstream stream(rest);
  for (std::string part; std::getline(stream, part, ':');) {
    const auto number = whole(part);
    if (!number) return std::nullopt;
    parts.push_back(static_cast<double>(*number));
  }
  if (parts.empty() || parts.size() > 3) return std::nullopt;
  // With days the first part is hours; without, one or two parts are minutes and seconds.
  const bool has_hours = dash != std::string::npos || parts.size() == 3;
  if (!has_hours) parts.insert(parts.begin(), 0.0);
  parts.resize(3, 0.0);
  return 24.0 * days + parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
}

std::vector<std::string> sbatch_options(const std::string& words) {
  std::vector<std::string> options;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const bool is_value = !word.starts_with('-') && !options.empty() &&
                          options.back().find_first_of("= ") == std::string::npos;
    if (word.starts_with('-'))
      options.push_back(word);
    else if (is_value)
      options.back() += " " + word;
    else
      throw Failure(
          ExitCode::usage,
          fmt::format("--sbatch: `{}` is no option of sbatch; write such as \"--partition=long "
                      "-A mine\"",
                      word));
  }
  return options;
}

SlurmSettings slurm_settings_in(const CaseDocument& document, CaseProblems& problems) {
  SlurmSettings settings;
  const CaseTable* const table = document.find("slurm");
  if (table == nullptr) return settings;
  check_keys(*table, keys, problems);
  for (const char* const key : {"partition", "account", "constraint"})
    if (const auto value = text_in(*table, key, problems)) {
      if (value->find_first_of(" \n\t") != std::string::npos)
        problems.add(table->find(key)->line, fmt::format("`{}` is one word", key));
      settings.options.push_back(fmt::format("--{}={}", key, *value));
    }
  if (const auto time = text_in(*table, "time", problems)) {
    settings.hours = walltime_hours(*time);
    if (!settings.hours)
      problems.add(
          table->find("time")->line,
          fmt::format(
              "`time` = \"{}\" is no walltime; write such as \"12:00:00\" or \"2-00:00:00\"",
              *time));
  }
  if (const CaseValue* const memory = table->find("memory_gb")) {
    const auto number = number_of(*memory);
    if (number && *number > 0.0)
      settings.memory = *number * bytes_of_gb;
    else
      problems.add(memory->line, "`memory_gb` is a number above 0");
  }
  settings.modules = modules_in(*table, problems);
  const auto count = [&](const char* key, std::int64_t least, int missing) {
    return static_cast<int>(whole_in(*table, key, least, most_tasks, problems).value_or(missing));
  };
  settings.throttle = count("throttle", 0, settings.throttle);
  settings.bundle = count("bundle", 1, settings.bundle);
  settings.signal_seconds = count("signal_seconds", 1, settings.signal_seconds);
  settings.most_restarts = count("most_restarts", 0, settings.most_restarts);
  return settings;
}

SlurmSettings slurm_settings_of(const std::filesystem::path& study_file) {
  CaseProblems problems(study_file);
  SlurmSettings settings = slurm_settings_in(read_case_document(study_file), problems);
  problems.throw_if_any();
  return settings;
}

}  // namespace millwear::orchestrator
