#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mill/load/steady_mixing.h"

namespace millwear::recorder {

/// What `millwear-recorder mix` is to do, from the words behind `mix`.
struct MixingOptions {
  std::filesystem::path deck;    ///< LIGGGHTS's input script, with one `run` of `plan.most` steps
  std::filesystem::path record;  ///< to be written: how it went (CSV)
  MixingPlan plan;
};

/// Throws Failure (usage) for an option that is unknown, missing or no number, and for steps that
/// do not fit.
[[nodiscard]] MixingOptions mixing_options(const std::vector<std::string>& arguments);

/// The text of `mix --help`.
[[nodiscard]] std::string mixing_help();

}  // namespace millwear::recorder
