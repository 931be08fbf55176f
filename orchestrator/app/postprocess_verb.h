#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"
#include "orchestrator/postprocess/hand_run.h"

namespace millwear::orchestrator {

/// What `millwear postprocess` is told.
struct PostprocessOptions {
  CommonOptions common;
  std::filesystem::path out;                     ///< empty: postprocess/NAME
  std::optional<std::filesystem::path> profile;  ///< of the deck's liner, where it is worn
  HandRun run{};                                 ///< but for its angle
  double angle_deg = 0.0;                        ///< that angle [degrees]
  std::optional<double> hours;                   ///< of milling to wear for
};

void add_options(CLI::App& verb, PostprocessOptions& options);

/// Turns the dumps of a run of the user's own into load, worn profile and mesh.
void postprocess_verb(const PostprocessOptions& options);

}  // namespace millwear::orchestrator
