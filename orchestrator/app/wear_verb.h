#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear wear` is told.
struct WearOptions {
  CommonOptions common;
  std::filesystem::path out;                 ///< empty: runs/NAME
  std::optional<std::filesystem::path> csv;  ///< to be written
};

void add_options(CLI::App& verb, WearOptions& options);

/// Applies the case's law to the loads of a campaign.
void wear_verb(const WearOptions& options);

}  // namespace millwear::orchestrator
