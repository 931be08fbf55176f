#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"

namespace millwear::orchestrator {

/// What `millwear mesh` is told.
struct MeshOptions {
  CommonOptions common;
  std::filesystem::path out;                     ///< empty: mesh/NAME
  std::optional<std::filesystem::path> profile;  ///< a worn one, instead of the new
};

void add_options(CLI::App& verb, MeshOptions& options);

/// Writes the liner's mesh and its section for CAD.
void mesh_verb(const MeshOptions& options);

}  // namespace millwear::orchestrator
