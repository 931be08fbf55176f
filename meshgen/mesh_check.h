#pragma once
#include <cstddef>

#include "meshgen/liner_mesh.h"

namespace millwear::meshgen {

struct MeshReport {
  std::size_t triangles;
  double smallest_angle;     ///< of any triangle [rad]
  double largest_deviation;  ///< mesh against profile, in either direction [m]
  double area;               ///< [m2]
};

/// Holds a finished mesh against the rules of LIGGGHTS and of its own order, without trusting how
/// it was built: every edge belongs to two triangles that run it in opposite senses (so a triangle
/// has at most 3 neighbours; LIGGGHTS takes 5), but for the rims at y = 0 and y = slice_length,
/// which are the same line (LIGGGHTS joins them through the periodic boundary); normals look into
/// the mill; no angle is below `settings.smallest_angle`; and every lifter's triangles lie within
/// `settings.tolerance` of the profile on that lifter.
/// Throws ResultRejected with the first rule that is broken.
[[nodiscard]] MeshReport check_mesh(const LinerMesh& mesh, const LinerProfile& profile,
                                    const MeshSettings& settings);

}  // namespace millwear::meshgen
