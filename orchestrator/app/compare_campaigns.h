#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// The most campaigns that one page tells apart by colour.
inline constexpr std::size_t most_compared = 8;

/// Prints the answers of campaigns side by side and writes the page that compares them, by default
/// `comparison.html` in the current folder. The campaigns' own folders stay as they are.
/// Throws Failure (usage) for too many, InputError where a folder holds no campaign; then nothing
/// is written.
void compare_campaigns(const std::vector<std::filesystem::path>& folders,
                       const std::optional<std::filesystem::path>& page, OutputForm form);

}  // namespace millwear::orchestrator
