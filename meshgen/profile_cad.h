#pragma once
#include <filesystem>

#include "mill/liner/liner_profile.h"

namespace millwear::meshgen {

/// The steel of one lifter with its plate as a solid in millimetres, in the mill's frame (axis
/// along y, lifter at six o'clock). Its surface is the profile's own polyline, its back the shell's
/// true circle. The time and the file's number are taken out, so the same profile gives the same
/// bytes. Throws ResultRejected if the solid's volume, read back, is not steel_area * slice_length
/// to 1e-6.
void write_step(const LinerProfile& profile, double slice_length,
                const std::filesystem::path& path);

/// The profile as one open polyline (xi, eta) in millimetres on the layer LINER.
/// Throws ResultRejected if its nodes do not read back to 1e-9 m.
void write_dxf(const LinerProfile& profile, const std::filesystem::path& path);

}  // namespace millwear::meshgen
