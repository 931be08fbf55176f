#include "orchestrator/app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "mill/base/failure.h"
#include "mill/base/nearest_word.h"
#include "mill/base/version.h"
#include "orchestrator/app/verbs.h"

namespace millwear::orchestrator {
namespace {

/// "`runn` is no verb; did you mean `run`? See `millwear --help`"
std::string spoken_unknown(const std::string& word, const std::string& kind,
                           const std::vector<std::string_view>& known, const std::string& program) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? fmt::format("`{}` is no {}; see `{} --help`", word, kind, program)
                      : fmt::format("`{}` is no {}; did you mean `{}`? See `{} --help`", word, kind,
                                    near, program);
}

std::string spoken_unknown_verb(const std::string& word) {
  std::vector<std::string_view> names;
  for (const Verb& verb : verbs()) names.emplace_back(verb.name);
  return spoken_unknown(word, "verb", names, "millwear");
}

/// What is wrong with the first word that found no place in the command line.
std::string spoken_unplaced(const CLI::App& app) {
  const std::string word = app.remaining(true).front();
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return spoken_unknown_verb(word);
  const std::string program = "millwear " + chosen.front()->get_name();
  if (!word.starts_with("-"))
    return fmt::format("`{}` is one word too many; see `{} --help`", word, program);
  std::vector<std::string> options;
  for (const CLI::Option* const option : chosen.front()->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  return spoken_unknown(word.substr(0, word.find('=')),
                        fmt::format("option of `{}`", chosen.front()->get_name()),
                        {options.begin(), options.end()}, program);
}

/// CLI11's own words for what else is wrong, with where to look.
std::string spoken_problem(const CLI::App& app, const CLI::ParseError& problem) {
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return "name a verb; see `millwear --help`";
  return fmt::format("{}; see `millwear {} --help`", problem.what(), chosen.front()->get_name());
}

/// The word where a verb should stand, if it is none.
std::string unknown_verb(int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  for (const Verb& verb : verbs())
    if (verb.name == std::string_view(argv[1])) return "";
  return argv[1];
}

ParsedCommandLine wrong_usage(const std::string& what) {
  fmt::print(stderr, "millwear: {}\n", what);
  return {{}, static_cast<int>(ExitCode::usage)};
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, const char* const* argv) {
  CLI::App app(
      "Predicts how the lifters of a tumbling mill wear: gmsh meshes, LIGGGHTS loads, a "
      "wear law, again and again until the liner is worn out.",
      "millwear");
  app.set_version_flag("--version", program_version());
  app.require_subcommand(1);
  app.footer(
      "\nStart with:\n  millwear check cases/pilot_mill/case.toml\n"
      "  millwear run cases/pilot_mill/case.toml\n\n"
      "Exit codes: 0 ok, 1 internal, 2 usage, 3 bad input, 4 external program failed,\n"
      "5 result rejected, 6 disk, 7 locked, 130/143 interrupted");
  if (const std::string word = unknown_verb(argc, argv); !word.empty())
    return wrong_usage(spoken_unknown_verb(word));
  std::function<void()> action;
  for (const Verb& verb : verbs()) {
    CLI::App* const command_line = app.add_subcommand(verb.name, verb.help);
    command_line->footer(std::string("\nExamples:\n") + verb.examples);
    command_line->callback(
        [&action, prepared = verb.prepare(*command_line)] { action = prepared; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return wrong_usage(spoken_unplaced(app));
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) return {{}, app.exit(problem)};
    return wrong_usage(spoken_problem(app, problem));
  }
  return {action, 0};
}

}  // namespace millwear::orchestrator
