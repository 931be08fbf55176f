#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/recording/recorder_option.h"

namespace CLI {
class App;
}

namespace millwear::recorder {

/// Gives up over wrong options. Throws Failure with ExitCode::usage.
[[noreturn]] void refuse(const std::string& why);

/// Adds an option of that name, need and range to `app`, which puts its value into `value`.
void add_option(CLI::App& app, const RecorderOption& option, std::filesystem::path& value);
void add_option(CLI::App& app, const RecorderOption& option,
                std::optional<std::filesystem::path>& value);
void add_option(CLI::App& app, const RecorderOption& option, long& value);
void add_option(CLI::App& app, const RecorderOption& option, std::optional<long>& value);
void add_option(CLI::App& app, const RecorderOption& option, std::optional<double>& value);

/// Takes what `for_each_option` tells of and adds it to `app`.
inline auto into(CLI::App& app) {
  return [&app](const RecorderOption& option, auto& value) { add_option(app, option, value); };
}

/// Puts the arguments into what `app`'s options are bound to; `help` is named to who errs.
/// Throws Failure with ExitCode::usage.
void parse_options(CLI::App& app, const std::vector<std::string>& arguments,
                   const std::string& help);

}  // namespace millwear::recorder
