#pragma once
#include <string>
#include <vector>

#include "orchestrator/pictures/image.h"
#include "orchestrator/pictures/liner_section.h"

namespace millwear::orchestrator {

/// A rectangle of the mill's section, or of whatever a picture shows [m].
struct PictureWindow {
  Eigen::Vector2d low;   ///< (x, z)
  Eigen::Vector2d high;  ///< (x, z)

  [[nodiscard]] Eigen::Vector2d size() const { return high - low; }
};

/// Commands for gnuplot: data and settings, and what `plot` shows of them (", $a with lines").
struct PlotParts {
  std::string settings;
  std::string plots;
};

/// A picture as PNG, with scale bar and legend, and a smaller one without them as JPEG for a page,
/// which has its own.
struct ChargePicture {
  std::string png;
  std::string jpeg;
};

/// Which pixels of a rendered image make one of each picture.
inline constexpr int png_shrinks = 2;
inline constexpr int jpeg_shrinks = 3;

/// Draws `over` an image that fills a window in both pictures, and `beside` it in the PNG.
[[nodiscard]] ChargePicture composed(const Image& image, const PictureWindow& window,
                                     const PlotParts& over, const PlotParts& beside);

/// Outlines filled with a colour.
[[nodiscard]] PlotParts filled(const std::vector<Outline>& outlines, const Rgb& colour);

/// A bar of a round length in the lower left corner.
[[nodiscard]] PlotParts scale_bar(const PictureWindow& window);

/// A bar of the colours of `ramp_colour`, from zero to the scale's end.
[[nodiscard]] PlotParts colour_bar(double end, const std::string& words);

/// A line of a legend.
struct ColouredName {
  std::string name;
  Rgb colour;
};

[[nodiscard]] PlotParts colour_names(const std::vector<ColouredName>& names);

[[nodiscard]] PlotParts operator+(const PlotParts& first, const PlotParts& second);

}  // namespace millwear::orchestrator
