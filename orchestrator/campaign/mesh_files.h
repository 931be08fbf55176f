#pragma once
#include <cstddef>
#include <filesystem>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// Writes the mesh of a liner (STL), its section (CSV, and STEP and DXF for CAD) and what is known
/// of the mesh (JSON) into a folder. Throws what meshgen throws.
void write_mesh(const Case& mill, const LinerProfile& liner, const std::filesystem::path& into);

/// Number of triangles of the mesh that `write_mesh` left in a folder.
[[nodiscard]] std::size_t triangles_of_mesh(const std::filesystem::path& mesh_folder);

}  // namespace millwear::orchestrator
