#include "recorder/options/option_parsing.h"

#include <CLI/CLI.hpp>

#include "mill/base/failure.h"

namespace millwear::recorder {
namespace {

template <class Value>
CLI::Option& added(CLI::App& app, const RecorderOption& option, Value& value) {
  const std::string short_name = option.short_name;
  const std::string names = short_name.empty() ? option.name : short_name + "," + option.name;
  auto& added = *app.add_option(names, value, option.help);
  if (option.need == OptionNeed::required) added.required();
  if (option.range == OptionRange::not_negative) added.check(CLI::NonNegativeNumber);
  if (option.range == OptionRange::positive) added.check(CLI::PositiveNumber);
  return added;
}

}  // namespace

void add_option(CLI::App& app, const RecorderOption& option, std::filesystem::path& value) {
  added(app, option, value);
}

void add_option(CLI::App& app, const RecorderOption& option,
                std::optional<std::filesystem::path>& value) {
  added(app, option, value);
}

void add_option(CLI::App& app, const RecorderOption& option, long& value) {
  auto& number = added(app, option, value);
  if (option.need == OptionNeed::optional) number.capture_default_str();
}

void add_option(CLI::App& app, const RecorderOption& option, std::optional<long>& value) {
  added(app, option, value);
}

void add_option(CLI::App& app, const RecorderOption& option, std::optional<double>& value) {
  added(app, option, value);
}

void refuse(const std::string& why) { throw Failure(ExitCode::usage, why); }

void parse_options(CLI::App& app, const std::vector<std::string>& arguments,
                   const std::string& help) {
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& problem) {
    refuse(std::string(problem.what()) + "; see " + help);
  }
}

}  // namespace millwear::recorder
