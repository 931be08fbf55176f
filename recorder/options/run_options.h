#pragma once
#include <string>
#include <vector>

#include "mill/recording/recorder_orders.h"

namespace millwear::recorder {

/// What `millwear-recorder run` is to do, from the words behind `run` (`to_arguments`).
/// Throws Failure (usage) for an option that is unknown or missing.
[[nodiscard]] DeckRunOptions run_options(const std::vector<std::string>& arguments);

/// The text of `run --help`.
[[nodiscard]] std::string run_help();

}  // namespace millwear::recorder
