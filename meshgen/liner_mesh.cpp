#include "meshgen/liner_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshgen/facet_outline.h"
#include "meshgen/gmsh_kernel.h"
#include "mill/base/constants.h"
#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"

namespace millwear::meshgen {
namespace {

constexpr int triangles_per_layer = 2;

void refuse_open_ends(const LinerProfile& profile) {
  const Eigen::Vector2d end = shifted_by_pitches(profile.sector, profile.nodes.front(), 1);
  const double gap = (end - profile.nodes.back()).norm();
  if (!(gap <= same_point)) {
    throw InputError(fmt::format(
        "the liner profile's ends lie {:.3g} m apart once carried over the pitch ({:g} m at most); "
        "they must be the same point of two neighbouring lifters",
        gap, same_point));
  }
}

/// The fewest layers at which the shortest facet keeps the smallest angle.
int layers_for(const std::vector<Eigen::Vector2d>& outline, double slice_length,
               const MeshSettings& settings) {
  const double shortest = std::ranges::min(facet_lengths(outline));
  const double tallest_layer = shortest / std::tan(settings.smallest_angle);
  const double layers = std::max(1.0, std::ceil(slice_length / tallest_layer - 1e-9));
  if (!(layers <= settings.most_layers)) {
    throw InputError(
        fmt::format("the shortest facet of the liner mesh is {:.3g} m: over a slice of {:.3g} m it "
                    "takes {:.0f} "
                    "layers to keep its triangles above {:.2g} degrees (the limit is {}); raise "
                    "`dem.mesh_tolerance` or smooth the profile",
                    shortest, slice_length, layers, settings.smallest_angle * degrees_per_radian,
                    settings.most_layers));
  }
  return static_cast<int>(layers);
}

std::vector<Eigen::Vector2d> ring_of(const LinerSector& sector,
                                     const std::vector<Eigen::Vector2d>& outline) {
  std::vector<Eigen::Vector2d> corners;
  for (int row = 0; row < sector.rows; ++row) {
    std::transform(outline.begin(), outline.end() - 1, std::back_inserter(corners),
                   [&](const Eigen::Vector2d& node) { return to_mill(sector, node, row, 0.0); });
  }
  return corners;
}

}  // namespace

TriangleAddress address_of(const LinerMesh& mesh, std::size_t triangle) {
  expect(triangle < mesh.triangles.size(), "a triangle whose address is asked for is of the mesh");
  const int strip = static_cast<int>(triangle) / triangles_per_layer;
  const int facet = strip / mesh.layers;
  return {facet / mesh.facets_per_lifter, facet % mesh.facets_per_lifter, strip % mesh.layers};
}

LinerMesh build_liner_mesh(const LinerProfile& profile, double slice_length,
                           const MeshSettings& settings) {
  auto outline = dem_outline(profile, settings.tolerance);
  refuse_open_ends(profile);
  expect(slice_length > 0.0, "a slice is longer than 0 m");
  if (settings.longest_facet) {
    outline = with_facets_below(outline, *settings.longest_facet);
  }
  const int layers = layers_for(outline, slice_length, settings);
  outline = with_facets_below(outline, slice_length / layers / std::tan(settings.smallest_angle));

  LinerMesh mesh{swept_polygon(ring_of(profile.sector, outline), slice_length, layers),
                 profile.sector.rows, static_cast<int>(outline.size()) - 1, layers, slice_length};
  const std::size_t expected = static_cast<std::size_t>(mesh.rows) * mesh.facets_per_lifter *
                               mesh.layers * triangles_per_layer;
  if (mesh.triangles.size() != expected) {
    throw ExternalProgramError(fmt::format("gmsh made {} triangles of the liner, not {}",
                                           mesh.triangles.size(), expected));
  }
  return mesh;
}

}  // namespace millwear::meshgen
