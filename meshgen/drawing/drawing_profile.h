#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/base/length_unit.h"

namespace millwear::meshgen {

/// The largest drawing that is read [bytes].
inline constexpr std::size_t largest_drawing = 64 * 1024 * 1024;

/// The open curve of a drawing, and what else is in it.
struct DrawingProfile {
  std::vector<Eigen::Vector2d> nodes;  ///< in the drawing's unit, arcs in chords of a degree
  std::optional<LengthUnit> unit;      ///< of $INSUNITS; none where it is unitless or another
  std::vector<std::string> drawn_as;   ///< "LINE (line 24)", a word for every piece of the curve
  std::vector<std::string> left_out;   ///< "TEXT (line 212) on layer `NOTES`: it is a text"
};

/// The one open curve of a DXF (ASCII or binary, R12 to 2018), or the one on `layer`: its lines,
/// arcs, polylines, splines and ellipses, joined end to end within 1e-4 of the size of the drawing,
/// also those in inserted blocks. Closed curves, texts, dimensions, hatches, what is hidden, and
/// open curves of less than half its length are left out.
/// Throws InputError (file, and line where there is one) for a drawing without an open curve, with
/// two of which neither is twice as long as the other, and one that does not parse.
[[nodiscard]] DrawingProfile drawing_profile(const std::filesystem::path& file,
                                             const std::optional<std::string>& layer);

}  // namespace millwear::meshgen
