#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace millwear::meshgen {

/// Writes one open polyline [m] on `layer` as a DXF in millimetres (AutoCAD 2000), by dxflib.
/// Throws DiskError.
void write_dxf_polyline(const std::vector<Eigen::Vector2d>& nodes, const std::string& layer,
                        const std::filesystem::path& path);

}  // namespace millwear::meshgen
