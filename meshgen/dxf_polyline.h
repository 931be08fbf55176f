#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// DXF by dxflib; what is written is in millimetres.
namespace millwear::meshgen {

/// Writes one open polyline [m] on `layer` (AutoCAD 2000). Throws DiskError.
void write_dxf_polyline(const std::vector<Eigen::Vector2d>& nodes, const std::string& layer,
                        const std::filesystem::path& path);

/// Nodes [m] of every polyline on `layer`, one after the other. Throws DiskError if there is no
/// such file.
[[nodiscard]] std::vector<Eigen::Vector2d> read_dxf_polyline(const std::string& layer,
                                                             const std::filesystem::path& path);

/// A polyline of a drawing, its arcs cut into chords of a degree or less.
struct DxfPolyline {
  std::string layer;
  bool closed;
  std::vector<Eigen::Vector2d> nodes;  ///< in the drawing's unit
};

struct DxfDrawing {
  std::vector<DxfPolyline> polylines;
  std::optional<double> metres_per_unit;  ///< by $INSUNITS; none where it is unitless or another
};

/// All polylines (POLYLINE and LWPOLYLINE) of a drawing. Throws DiskError if there is no such file.
[[nodiscard]] DxfDrawing read_dxf_drawing(const std::filesystem::path& path);

}  // namespace millwear::meshgen
