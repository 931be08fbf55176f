#include "orchestrator/gauge/gauge_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "meshgen/dxf_polyline.h"
#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

bool is_dxf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".dxf";
}

CurveRows curve_in_table(const CurveFile& file) {
  if (file.layer)
    throw InputError(
        fmt::format("{}: --layer goes with a DXF only; leave it out", file.path.string()));
  return curve_rows(read_text_file(file.path, largest_curve_file), file.path, file.unit);
}

std::string layers_of(const meshgen::DxfDrawing& drawing) {
  std::set<std::string> layers;
  for (const auto& polyline : drawing.polylines) layers.insert(in_quotes(polyline.layer));
  return fmt::format("{}", fmt::join(layers, ", "));
}

const meshgen::DxfPolyline& polyline_of(const CurveFile& file, const meshgen::DxfDrawing& drawing) {
  std::vector<const meshgen::DxfPolyline*> found;
  for (const auto& polyline : drawing.polylines)
    if (!file.layer || polyline.layer == *file.layer) found.push_back(&polyline);
  const std::string name = file.path.string();
  if (drawing.polylines.empty())
    throw InputError(fmt::format(
        "{}: no polyline is in the drawing; join the lines and arcs of the profile to one polyline",
        name));
  if (found.empty())
    throw InputError(fmt::format("{}: no polyline is on layer {}; they are on {}", name,
                                 in_quotes(*file.layer), layers_of(drawing)));
  if (found.size() > 1)
    throw InputError(
        fmt::format("{}: {} polylines, on {}; keep the profile alone on a layer and name it with "
                    "--layer",
                    name, found.size(), layers_of(drawing)));
  if (found.front()->closed)
    throw InputError(
        fmt::format("{}: the polyline is closed; keep the surface that the charge touches, from "
                    "plate to plate",
                    name));
  return *found.front();
}

CurveRows curve_in_dxf(const CurveFile& file) {
  if (!fs::is_regular_file(file.path))
    throw InputError(fmt::format("{}: there is no such file; check its name", file.path.string()));
  if (fs::file_size(file.path) > largest_curve_file)
    throw InputError(fmt::format("{}: the file is over {} MiB; keep one profile a drawing",
                                 file.path.string(), largest_curve_file >> 20));
  const auto drawing = meshgen::read_dxf_drawing(file.path);
  const auto& polyline = polyline_of(file, drawing);
  const auto scale = file.unit ? name_of(*file.unit).metres : drawing.metres_per_unit;
  if (!scale)
    throw InputError(fmt::format("{}: the drawing does not say its unit; say it with --unit",
                                 file.path.string()));
  CurveRows curve{CurveFrame::own, {}, {}, false};
  for (const auto& node : polyline.nodes) {
    if (!node.allFinite())
      throw InputError(fmt::format("{}: a place of the polyline is no number; mend the drawing",
                                   file.path.string()));
    curve.nodes.emplace_back(*scale * node);
  }
  return curve;
}

}  // namespace

CurveRows read_gauge_curve(const CurveFile& file) {
  return is_dxf(file.path) ? curve_in_dxf(file) : curve_in_table(file);
}

}  // namespace millwear::orchestrator
