#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "orchestrator/vtk/poly_data.h"

namespace millwear::orchestrator {

enum class LinerExtent { ring, one_lifter };

/// The profile with a further node wherever one of `bins` even bins along it ends: every segment
/// lies in one bin.
[[nodiscard]] LinerProfile cut_at_bins(const LinerProfile& profile, Eigen::Index bins);

/// The bin of every segment of such an outline.
[[nodiscard]] std::vector<Eigen::Index> bins_of_segments(const LinerProfile& outline,
                                                         Eigen::Index bins);

/// Where the surface lies.
struct LinerPlacement {
  LinerExtent extent;
  double slice_length;  ///< it reaches from y = 0 to here [m]
  double mill_angle;    ///< by which the mill has turned, along xi [rad]
};

/// The surface of the liner in the mill's frame (mill/liner/mill_frame.h): a quadrilateral a
/// segment of the outline and lifter, its normal towards the charge. `by_segment` has a number a
/// segment, the same on all lifters.
[[nodiscard]] VtkPolyData liner_surface(const LinerProfile& outline,
                                        const std::vector<VtkArray>& by_segment,
                                        const LinerPlacement& placement);

}  // namespace millwear::orchestrator
