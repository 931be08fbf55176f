#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear tune` is told.
struct TuneOptions {
  CommonOptions common;
  std::filesystem::path out;  ///< empty: runs/NAME
  std::optional<int> ranks;   ///< instead of the case's
};

void add_options(CLI::App& verb, TuneOptions& options);

/// Times skins and splits, and prints the fastest.
void tune_verb(const TuneOptions& options);

}  // namespace millwear::orchestrator
