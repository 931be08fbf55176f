#pragma once
#include <optional>
#include <vector>

#include "mill/liner/rotation.h"
#include "orchestrator/loads/load_along_profile.h"
#include "orchestrator/vtk/poly_data.h"
#include "wear/record/profile_index.h"

namespace millwear::orchestrator {

/// The distance of every segment's middle from the surface of the new liner: `wear_depth_m`.
[[nodiscard]] VtkArray wear_depth(const LinerProfile& outline, const wear::ProfileIndex& fresh);

/// A cycle's load on the liner that it was measured on.
struct LoadOnLiner {
  LinerProfile liner;  ///< in the steel's frame
  Rotation rotation;   ///< which way the mill turned
  LoadAlongProfile load;
};

/// The load carried to a liner that was worn from that one, a value for every segment of it cut at
/// the load's bins (`cut_at_bins`): the smoothed wear rate, and as measured sliding work, normal
/// dissipation and contacts.
[[nodiscard]] std::vector<VtkArray> load_values(const LoadOnLiner& measured,
                                                const LinerProfile& worn);

}  // namespace millwear::orchestrator
