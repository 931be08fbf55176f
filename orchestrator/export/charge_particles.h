#pragma once
#include "mill/liner/rotation.h"
#include "orchestrator/vtk/poly_data.h"
#include "wear/charge/charge_frames.h"

namespace millwear::orchestrator {

/// The particles of a frame as points in the mill's frame, each a vertex: number, class, diameter
/// and speed, and in the first frame velocity and spin. The DEM's mill always turns the same way:
/// where the mill is reversed the points are its mirror image, so that they lie on the liner in the
/// steel's frame. There is such a frame (std::logic_error).
[[nodiscard]] VtkPolyData charge_particles(const wear::ChargeFrames& frames, std::size_t frame,
                                           Rotation rotation);

}  // namespace millwear::orchestrator
