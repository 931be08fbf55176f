#pragma once
#include <filesystem>
#include <optional>

#include "mill/case/case.h"
#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear draw` is told.
struct DrawOptions {
  CommonOptions common;
  std::filesystem::path out;                     ///< empty: drawings/NAME
  std::optional<std::filesystem::path> profile;  ///< a worn one, instead of the new
};

void add_options(CLI::App& verb, DrawOptions& options);

/// Publishes `liner.svg` and `liner.png` in a folder, the liner in its mill to scale.
void publish_drawings(const Case& mill, const std::filesystem::path& folder);

/// Draws the liner in its mill to scale, as SVG and PNG.
void draw_verb(const DrawOptions& options);

}  // namespace millwear::orchestrator
