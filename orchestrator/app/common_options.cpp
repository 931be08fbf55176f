#include "orchestrator/app/common_options.h"

#include <CLI/CLI.hpp>

namespace millwear::orchestrator {
namespace {

constexpr int most_ranks = 100000;

}  // namespace

void add_options(CLI::App& verb, CommonOptions& options) {
  verb.add_option("case", options.case_file, "The case file (docs/case_file.md)")->required();
  add_output_options(verb, options);
}

void add_output_options(CLI::App& verb, CommonOptions& options) {
  verb.add_flag_callback(
      "--json", [&] { options.form = OutputForm::json; }, "Print results as JSON");
  verb.add_flag_callback(
      "-q,--quiet", [&] { options.verbosity = Verbosity::quiet; }, "Print errors only");
  verb.add_flag_callback(
      "-v,--verbose", [&] { options.verbosity = Verbosity::verbose; }, "Print more");
}

void add_campaign_folder(CLI::App& verb, std::filesystem::path& out) {
  verb.add_option("--out", out, "Folder of the campaign; by default runs/NAME");
}

void add_ranks(CLI::App& verb, std::optional<int>& ranks) {
  verb.add_option("--ranks", ranks, "MPI ranks, instead of the case's")
      ->check(CLI::Range(1, most_ranks));
}

void add_readings_folder(CLI::App& verb, std::optional<std::filesystem::path>& readings) {
  verb.add_option("--readings", readings,
                  "Folder of the gauge readings; by default `gauge` beside the case file");
}

void add_csv(CLI::App& verb, std::optional<std::filesystem::path>& csv, const std::string& what) {
  verb.add_option("--csv", csv, what);
}

}  // namespace millwear::orchestrator
