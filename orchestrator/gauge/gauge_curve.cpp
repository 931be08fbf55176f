#include "orchestrator/gauge/gauge_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "meshgen/drawing/drawing_profile.h"
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

GaugeCurve curve_in_table(const CurveFile& file) {
  if (file.layer)
    throw InputError(
        fmt::format("{}: --layer goes with a DXF only; leave it out", file.path.string()));
  return {curve_rows(read_text_file(file.path, largest_curve_file), file.path, file.unit), {}, {}};
}

GaugeCurve curve_in_dxf(const CurveFile& file) {
  auto drawn = meshgen::drawing_profile(file.path, file.layer);
  const auto unit = file.unit ? file.unit : drawn.unit;
  if (!unit)
    throw InputError(fmt::format("{}: the drawing does not say its unit; say it with --unit",
                                 file.path.string()));
  GaugeCurve curve{{CurveFrame::own, std::move(drawn.nodes), {}, false},
                   std::move(drawn.drawn_as),
                   std::move(drawn.left_out)};
  for (Eigen::Vector2d& node : curve.rows.nodes) node *= name_of(*unit).metres;
  return curve;
}

}  // namespace

GaugeCurve read_gauge_curve(const CurveFile& file) {
  return is_dxf(file.path) ? curve_in_dxf(file) : curve_in_table(file);
}

}  // namespace millwear::orchestrator
