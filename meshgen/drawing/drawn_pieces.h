#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace millwear::meshgen {

/// A line, an arc, a polyline or a spline of a drawing, in chords.
struct DrawnPiece {
  std::string layer;                   ///< UTF-8
  int line;                            ///< of its entity in the file
  std::vector<Eigen::Vector2d> nodes;  ///< in the drawing's unit
};

/// The curves of a DXF by GDAL (its driver DXF): inserted blocks in place, object coordinates,
/// bulges, splines and ellipses as chords of a degree. `text` is that of `DxfContents`, whose
/// handles are lines. Throws InputError where GDAL cannot read it, and for a curve that is not
/// flat.
[[nodiscard]] std::vector<DrawnPiece> drawn_pieces(const std::string& text,
                                                   const std::filesystem::path& file);

/// A word of a DXF (such as a layer's name) as UTF-8: in the code page that the drawing says.
[[nodiscard]] std::string utf8_of(const std::string& word, const std::string& code_page);

}  // namespace millwear::meshgen
