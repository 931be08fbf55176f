#pragma once
#include <filesystem>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear status` is told.
struct StatusOptions {
  CommonOptions common;
  std::filesystem::path out;  ///< empty: runs/NAME
};

void add_options(CLI::App& verb, StatusOptions& options);

/// Says how far the campaign is.
void status_verb(const StatusOptions& options);

}  // namespace millwear::orchestrator
