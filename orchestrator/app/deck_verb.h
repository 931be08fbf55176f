#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear deck` is told.
struct DeckOptions {
  CommonOptions common;
  std::filesystem::path out;                     ///< empty: deck/NAME
  std::optional<std::filesystem::path> profile;  ///< a worn one, instead of the new
  std::optional<int> ranks;                      ///< instead of the case's
};

void add_options(CLI::App& verb, DeckOptions& options);

/// Writes mesh and decks of a first cycle.
void deck_verb(const DeckOptions& options);

}  // namespace millwear::orchestrator
