#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/app/postprocess_verb.h"
#include "orchestrator/dem_run/progress.h"
#include "orchestrator/gauge/import_options.h"
#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

enum class Verb {
  check,
  mesh,
  deck,
  run,
  status,
  report,
  wear,
  import,
  compare,
  calibrate,
  tune,
  postprocess
};

enum class OutputForm { text, json };

/// What the user asked for.
struct Command {
  Verb verb;
  std::filesystem::path case_file;
  std::filesystem::path out;  ///< empty: runs/NAME
  OutputForm form;
  Verbosity verbosity;
  bool dry_run;                                  ///< run: say what would run, and run nothing
  bool explain;                                  ///< run: say why each stage runs
  std::optional<int> ranks;                      ///< instead of the case's
  std::optional<std::filesystem::path> profile;  ///< mesh, deck: a worn profile instead of the new
  std::optional<std::filesystem::path> csv;      ///< wear, compare, calibrate: file of the table
  std::optional<std::filesystem::path> readings{};  ///< of the gauge readings
  ImportOptions import{};
  std::vector<std::filesystem::path> compared_profiles{};  ///< compare: none, or two
  std::optional<double> until{};  ///< calibrate: fit to readings up to here only [h]
  std::optional<double>
      calibrate_until{};              ///< compare: instead of the case's [h]; 0 for not at all
  std::optional<GaugeOn> gauge_on{};  ///< compare, calibrated
  std::optional<std::filesystem::path> plot{};  ///< compare, calibrated: file of the picture
  PostprocessOptions postprocess{};
};

/// The command, or the exit code with which the program ends at once (help, version, bad usage).
struct ParsedCommandLine {
  std::optional<Command> command;
  int exit_code;
};

[[nodiscard]] ParsedCommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace millwear::orchestrator
