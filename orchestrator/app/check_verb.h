#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear check` is told.
struct CheckOptions {
  CommonOptions common;
  std::optional<std::filesystem::path> picture;  ///< folder of the liner's drawings
  std::vector<int> ranks;  ///< to be compared; empty: what the case asks for, without a comparison
};

void add_options(CLI::App& verb, CheckOptions& options);

/// Prints what the case would simulate.
void check_verb(const CheckOptions& options);

}  // namespace millwear::orchestrator
