#pragma once
#include <filesystem>
#include <optional>

#include "mill/case/case.h"
#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// Adds --profile, a worn liner in place of the case's new one.
void add_worn_profile(CLI::App& verb, std::optional<std::filesystem::path>& profile);

/// The case, with the worn profile as its liner where one is given.
[[nodiscard]] Case case_with_profile(const CommonOptions& common,
                                     const std::optional<std::filesystem::path>& profile);

/// The folder that was asked for, or WHAT/NAME.
[[nodiscard]] std::filesystem::path folder_or_default(const std::filesystem::path& out,
                                                      const char* what, const Case& mill);

/// Prints which files lie in a folder now.
void print_folder(const CommonOptions& common, const std::filesystem::path& folder,
                  const char* what);

}  // namespace millwear::orchestrator
