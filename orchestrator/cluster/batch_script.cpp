#include "orchestrator/cluster/batch_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

#include "batch_templates.h"
#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr double bytes_of_mb = 1 << 20;

std::string spoken_walltime(double hours) {
  const auto seconds = static_cast<long>(std::ceil(3600.0 * hours));
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::map<std::string, std::string, std::less<>> values_of(const BatchJob& job) {
  return {{"name", job.name},
          {"log", job.log},
          {"tasks", std::to_string(job.tasks)},
          {"cores", std::to_string(job.cores)},
          {"time", spoken_walltime(job.hours)},
          {"memory_mb", fmt::format("{:.0f}", std::ceil(job.memory / bytes_of_mb))},
          {"options", fmt::format("{}", fmt::join(job.options, "\n"))},
          {"setup", job.setup},
          {"command", job.command},
          {"signal_seconds", std::to_string(job.signal_seconds)},
          {"most_restarts", std::to_string(job.most_restarts)}};
}

}  // namespace

std::string_view slurm_template() { return slurm_batch_template; }

std::string batch_script(std::string_view text, const std::string& file, const BatchJob& job) {
  const auto values = values_of(job);
  std::string filled;
  bool has_command = false;
  for (std::size_t at = 0; at < text.size();) {
    const auto open = text.find("{{", at);
    filled += text.substr(at, open == std::string_view::npos ? open : open - at);
    if (open == std::string_view::npos) break;
    const auto close = text.find("}}", open);
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(open), '\n');
    const std::string_view name =
        close == std::string_view::npos ? "" : text.substr(open + 2, close - open - 2);
    const auto value = values.find(name);
    if (value == values.end())
      throw InputError(fmt::format(
          "{}:{}: `{}` is no placeholder of a batch script; there are {{{{{}}}}}", file, line,
          text.substr(open, std::min<std::size_t>(30, text.find('\n', open) - open)),
          fmt::join(values | std::views::keys, "}}, {{")));
    filled += value->second;
    has_command = has_command || name == "command";
    at = close + 2;
  }
  if (!has_command)
    throw InputError(
        fmt::format("{}:1: the template has no {{{{command}}}}, so it would run nothing", file));
  return filled;
}

}  // namespace millwear::orchestrator
