#include "orchestrator/app/liner_choice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "mill/case_file/case_file.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/drawing/drawn_liner_reader.h"

namespace millwear::orchestrator {

void add_worn_profile(CLI::App& verb, std::optional<std::filesystem::path>& profile) {
  verb.add_option("--profile", profile,
                  "CSV of a worn profile (xi_m,eta_m) in place of the new one");
}

Case case_with_profile(const CommonOptions& common,
                       const std::optional<std::filesystem::path>& profile) {
  Case mill = read_case(common.case_file, read_drawn_liner);
  if (profile) mill.liner = read_profile_csv(*profile, mill.liner.sector);
  return mill;
}

std::filesystem::path folder_or_default(const std::filesystem::path& out, const char* what,
                                        const Case& mill) {
  return out.empty() ? std::filesystem::path(what) / mill.name : out;
}

void print_folder(const CommonOptions& common, const std::filesystem::path& folder,
                  const char* what) {
  if (common.form == OutputForm::json)
    fmt::print("{}\n", nlohmann::json{{"folder", folder.string()}}.dump());
  else
    fmt::print("{} in {}\n", what, folder.string());
}

}  // namespace millwear::orchestrator
