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

double metres_per(LengthUnit unit) { return unit == LengthUnit::metre ? 1.0 : 1e-3; }

bool is_dxf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".dxf";
}

GaugeCurve curve_in_csv(const CurveFile& file) {
  const UserTable table = user_table(read_text_file(file.path, largest_curve_file), file.path);
  const auto xi = column_named(table, "xi_m");
  const auto eta = column_named(table, "eta_m");
  const auto x = column_named(table, "x");
  const auto y = column_named(table, "y");
  const bool in_master_frame = xi && eta;
  const int head = std::max(table.header.line, 1);
  if (!in_master_frame && !(x && y))
    refuse_line(file.path, head,
                "the header names neither `xi_m` and `eta_m` (the master frame, in metres) nor `x` "
                "and `y`; it reads `x,y`, then a point a line");
  if (in_master_frame && file.unit.value_or(LengthUnit::metre) != LengthUnit::metre)
    refuse_line(file.path, head,
                "`xi_m` and `eta_m` are in metres and --unit says mm; name the columns `x,y`");
  if (file.layer)
    throw InputError(
        fmt::format("{}: --layer goes with a DXF only; leave it out", file.path.string()));
  const double scale = in_master_frame ? 1.0 : metres_per(file.unit.value_or(LengthUnit::metre));
  GaugeCurve curve{{}, in_master_frame};
  for (const UserRow& row : table.rows)
    curve.nodes.emplace_back(
        scale * number_in(table, row, in_master_frame ? *xi : *x, "a length, such as 215.0"),
        scale * number_in(table, row, in_master_frame ? *eta : *y, "a length, such as 215.0"));
  return curve;
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

GaugeCurve curve_in_dxf(const CurveFile& file) {
  if (!fs::is_regular_file(file.path))
    throw InputError(fmt::format("{}: there is no such file; check its name", file.path.string()));
  if (fs::file_size(file.path) > largest_curve_file)
    throw InputError(fmt::format("{}: the file is over {} MiB; keep one profile a drawing",
                                 file.path.string(), largest_curve_file >> 20));
  const auto drawing = meshgen::read_dxf_drawing(file.path);
  const auto& polyline = polyline_of(file, drawing);
  const auto scale = file.unit ? metres_per(*file.unit) : drawing.metres_per_unit;
  if (!scale)
    throw InputError(fmt::format("{}: the drawing does not say its unit; say it with --unit",
                                 file.path.string()));
  GaugeCurve curve{{}, false};
  for (const auto& node : polyline.nodes) {
    if (!node.allFinite())
      throw InputError(fmt::format("{}: a place of the polyline is no number; mend the drawing",
                                   file.path.string()));
    curve.nodes.emplace_back(*scale * node);
  }
  return curve;
}

}  // namespace

GaugeCurve read_gauge_curve(const CurveFile& file) {
  return is_dxf(file.path) ? curve_in_dxf(file) : curve_in_csv(file);
}

}  // namespace millwear::orchestrator
