#pragma once
#include <string>
#include <vector>

#include "mill/recording/recorder_orders.h"

namespace millwear::recorder {

/// What `millwear-recorder mix` is to do, from the words behind `mix` (`to_arguments`).
/// Throws Failure (usage) for an option that is unknown, missing or no number, and for steps that
/// do not fit.
[[nodiscard]] MixingOptions mixing_options(const std::vector<std::string>& arguments);

/// The text of `mix --help`.
[[nodiscard]] std::string mixing_help();

}  // namespace millwear::recorder
