#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "orchestrator/dem_run/progress.h"

namespace CLI {
class App;
}

namespace millwear::orchestrator {

enum class OutputForm { text, json };

/// The longest time of milling that a verb takes [h].
inline constexpr double most_hours = 1e6;

/// What every verb is told.
struct CommonOptions {
  std::filesystem::path case_file;
  OutputForm form = OutputForm::text;
  Verbosity verbosity = Verbosity::normal;
};

/// Adds the case file, --json, --quiet and --verbose to a verb's command line.
void add_options(CLI::App& verb, CommonOptions& options);

/// Adds the last three alone.
void add_output_options(CLI::App& verb, CommonOptions& options);

/// Adds --out, the folder of the case's campaign.
void add_campaign_folder(CLI::App& verb, std::filesystem::path& out);

/// Adds --ranks.
void add_ranks(CLI::App& verb, std::optional<int>& ranks);

/// Adds --readings, the folder of the gauge readings.
void add_readings_folder(CLI::App& verb, std::optional<std::filesystem::path>& readings);

/// Adds --csv, with what is written there.
void add_csv(CLI::App& verb, std::optional<std::filesystem::path>& csv, const std::string& what);

}  // namespace millwear::orchestrator
