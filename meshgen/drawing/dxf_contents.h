#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "meshgen/drawing/dxf_groups.h"
#include "mill/base/length_unit.h"

namespace millwear::meshgen {

/// Something in a drawing that is not taken for the profile.
struct LeftOut {
  std::string entity;  ///< such as LWPOLYLINE
  std::string layer;
  int line;
  std::string why;
};

/// The curves that a drawing shows.
struct DxfContents {
  std::vector<DxfGroup> groups;  ///< of the drawing without what is left out; the handle (group 5)
                                 ///< of every entity is the line it begins on, as a decimal number
  std::map<int, std::string> types;  ///< of the entities that are kept, by their lines
  std::vector<LeftOut> left_out;
  std::optional<LengthUnit> unit;  ///< of $INSUNITS
};

/// Keeps what is a curve (LINE, ARC, LWPOLYLINE, POLYLINE, SPLINE, ELLIPSE) and INSERT, in model
/// space, visible, on a layer that is neither off nor frozen.
/// Throws InputError (file:line) for a polyline with another number of vertices than it says, and a
/// spline whose knots are not as many as its degree and control points ask for, or fall.
[[nodiscard]] DxfContents dxf_contents(std::vector<DxfGroup> groups,
                                       const std::filesystem::path& file);

}  // namespace millwear::meshgen
