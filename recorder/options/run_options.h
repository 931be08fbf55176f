#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace millwear::recorder {

/// The deck that `millwear-recorder run` is to run, from the words behind `run`.
/// Throws Failure (usage) for an option that is unknown or missing.
[[nodiscard]] std::filesystem::path deck_option(const std::vector<std::string>& arguments);

/// The text of `run --help`.
[[nodiscard]] std::string run_help();

}  // namespace millwear::recorder
