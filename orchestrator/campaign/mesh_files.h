#pragma once
#include <cstddef>
#include <filesystem>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// Writes the mesh of a liner (STL), its section (CSV, and STEP and DXF for CAD) and what is known
/// of the mesh (JSON) into a folder. Throws what meshgen throws.
void write_mesh(const Case& mill, const LinerProfile& liner, const std::filesystem::path& into);

/// Writes the mesh of a liner alone. Throws what meshgen throws.
void write_mesh_stl(const Case& mill, const LinerProfile& liner, const std::filesystem::path& file);

/// Makes the mesh of the case's new liner and holds it against every rule that `write_mesh` does;
/// writes nothing. Throws what meshgen throws, an InputError with the case's file before it.
void check_liner_can_be_meshed(const Case& mill);

/// Number of triangles of the mesh that `write_mesh` left in a folder.
[[nodiscard]] std::size_t triangles_of_mesh(const std::filesystem::path& mesh_folder);

}  // namespace millwear::orchestrator
