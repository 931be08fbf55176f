#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "meshgen/triangulation.h"

/// What gmsh does for us. gmsh holds one model a process: calls wait for each other. It runs with
/// one thread and a fixed seed, so the same input gives the same bytes. Every function throws
/// ExternalProgramError with gmsh's own words where gmsh fails.
namespace millwear::meshgen {

/// The surface swept along y from 0 to `length` [m] by the closed polygon of `corners` (x, z) [m]:
/// side by side (side i runs from corner i to i + 1), in each `layers` along +y, two triangles a
/// layer. Normals point to the right of the polygon's sense in the (x, z) plane seen from -y.
[[nodiscard]] Triangulation swept_polygon(const std::vector<Eigen::Vector2d>& corners,
                                          double length, int layers);

/// Writes ASCII STL [m], triangles in their order, 16 digits.
void write_ascii_stl(const Triangulation& surface, const std::filesystem::path& path);

/// A section of steel: an open polyline closed through a circle about the origin.
struct SteelSection {
  std::vector<Eigen::Vector2d> surface;  ///< (x, z) [m], from one sector edge to the next
  double shell_radius;                   ///< [m]
};

/// Writes the solid swept along y by `section` over `length` [m], in millimetres.
void write_solid_step(const SteelSection& section, double length,
                      const std::filesystem::path& path);

/// Volume of all solids of a STEP file [m3]. OpenCASCADE reads every file in millimetres; gmsh's
/// `Geometry.OCCTargetUnit` is not used: the first import of a process ignores it.
[[nodiscard]] double volume_of_step(const std::filesystem::path& path);

}  // namespace millwear::meshgen
