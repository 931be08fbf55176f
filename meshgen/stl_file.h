#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <vector>

#include "meshgen/triangulation.h"

namespace millwear::meshgen {

/// Writes ASCII STL in the triangulation's order, reads it back and compares, then renames it into
/// place: the file is never partial. The same mesh gives the same bytes.
/// Throws ResultRejected if it does not read back the same, DiskError if it cannot be written.
void write_stl(const Triangulation& mesh, const std::filesystem::path& path);

/// Corners of one triangle [m].
using StlFacet = std::array<Eigen::Vector3d, 3>;

/// All facets of an ASCII STL file with one solid, in its order.
/// Throws DiskError if it cannot be read, ResultRejected if it is incomplete or not ASCII STL.
[[nodiscard]] std::vector<StlFacet> read_stl(const std::filesystem::path& path);

}  // namespace millwear::meshgen
