#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

/// DXF by dxflib, in millimetres.
namespace millwear::meshgen {

/// Writes one open polyline [m] on `layer` (AutoCAD 2000). Throws DiskError.
void write_dxf_polyline(const std::vector<Eigen::Vector2d>& nodes, const std::string& layer,
                        const std::filesystem::path& path);

/// Nodes [m] of every polyline on `layer`, one after the other. Throws DiskError if there is no
/// such file.
[[nodiscard]] std::vector<Eigen::Vector2d> read_dxf_polyline(const std::string& layer,
                                                             const std::filesystem::path& path);

}  // namespace millwear::meshgen
