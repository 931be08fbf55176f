#pragma once
#include <filesystem>
#include <optional>

#include "meshgen/triangulation.h"
#include "mill/liner/liner_profile.h"

namespace millwear::meshgen {

struct MeshSettings {
  double tolerance;  ///< mesh against profile [m], a few per cent of the smallest particle's radius
  std::optional<double> longest_facet = std::nullopt;  ///< along the profile [m]
  /// [rad]; layers along the axis are added until no triangle has a smaller angle. LIGGGHTS warns
  /// below 0.5 degrees and takes two edges within 0.26 for one line.
  double smallest_angle = 0.0104719755119659775;  // 0.6 degrees
  int most_layers = 20;  ///< a profile that needs more has facets too short for this slice
};

/// The liner of the periodic slice as LIGGGHTS sees it: mill frame [m], mill angle 0, y from 0 to
/// exactly slice_length, normals towards the charge. Triangles are ordered by lifter (0 first,
/// along the direction of rotation), within it by facet (in the profile's order), within it by
/// layer along +y, two for each.
struct LinerMesh : Triangulation {
  int rows;
  int facets_per_lifter;
  int layers;
  double slice_length;  ///< [m]
};

/// Where on the liner a triangle lies; all from 0.
struct TriangleAddress {
  int lifter;
  int facet;
  int layer;
  bool operator==(const TriangleAddress&) const = default;
};

/// `triangle` counts from 0 in the order of the STL file. There is such a one
/// (std::logic_error).
[[nodiscard]] TriangleAddress address_of(const LinerMesh& mesh, std::size_t triangle);

/// The ring of lifters with the outline of `dem_outline`.
/// Throws InputError for a profile or settings that cannot be meshed (it crosses itself, its ends
/// do not meet over the pitch, facets too short for the slice), ExternalProgramError if gmsh fails.
[[nodiscard]] LinerMesh build_liner_mesh(const LinerProfile& profile, double slice_length,
                                         const MeshSettings& settings);

}  // namespace millwear::meshgen
