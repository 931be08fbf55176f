#include "orchestrator/pictures/composed.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "orchestrator/pictures/colour_ramp.h"
#include "orchestrator/pictures/gnuplot.h"
#include "orchestrator/process/memory_file.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector2d;

constexpr int legend_width = 190;  // px
constexpr double legend_top = 0.92;

/// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= length) return factor * power;
  return power;
}

std::string spoken_length(double length) {
  return length < 1.0 ? fmt::format("{:g} mm", 1e3 * length) : fmt::format("{:g} m", length);
}

/// Scales that fill the picture up to `right`, a share of its width, without axes.
std::string scales(const PictureWindow& window, double right) {
  return fmt::format(
      "unset border\nunset xtics\nunset ytics\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
      "set lmargin at screen 0\nset bmargin at screen 0\nset tmargin at screen 1\n"
      "set rmargin at screen {}\n",
      window.low.x(), window.high.x(), window.low.y(), window.high.y(), right);
}

/// The image in its window; gnuplot reads it from `file`.
std::string image_plot(const MemoryFile& file, const PictureWindow& window,
                       const PictureSize& size) {
  const Vector2d middle = 0.5 * (window.low + window.high);
  const Vector2d pixel = window.size().array() / Vector2d(size.width, size.height).array();
  return fmt::format(
      "plot '{}' binary array=({},{}) flipy format='%uchar%uchar%uchar' center=({:.9g},{:.9g}) "
      "dx={:.9g} dy={:.9g} with rgbimage notitle",
      file.path().string(), size.width, size.height, middle.x(), middle.y(), pixel.x(), pixel.y());
}

std::string drawn(const std::string& terminal, const Image& image, const PictureWindow& window,
                  double right, const PlotParts& parts) {
  const MemoryFile file("a picture of the charge", image.pixels);
  return gnuplot_output(terminal + scales(window, right) + parts.settings +
                        image_plot(file, window, image.size) + parts.plots + "\n");
}

}  // namespace

ChargePicture composed(const Image& image, const PictureWindow& window, const PlotParts& over,
                       const PlotParts& beside) {
  const Image large = shrunk(image, png_shrinks);
  const Image small = shrunk(image, jpeg_shrinks);
  const int width = large.size.width + legend_width;
  return {drawn(fmt::format(
                    "set terminal pngcairo size {},{} font 'DejaVu Sans,12' background '#ffffff'\n",
                    width, large.size.height),
                large, window, static_cast<double>(large.size.width) / width, over + beside),
          drawn(fmt::format("set terminal jpeg size {},{} font 'DejaVu Sans,11'\n",
                            small.size.width, small.size.height),
                small, window, 1.0, over)};
}

PlotParts filled(const std::vector<Outline>& outlines, const Rgb& colour) {
  std::string text = "$filled << EOD\n";
  for (const Outline& outline : outlines) {
    for (const auto& place : outline)
      fmt::format_to(std::back_inserter(text), "{:.6g} {:.6g}\n", place.x(), place.y());
    text += "\n";
  }
  return {text + "EOD\n",
          fmt::format(", $filled with filledcurves closed fc rgb '{}' notitle", hex(colour))};
}

PlotParts scale_bar(const PictureWindow& window) {
  const Vector2d size = window.size();
  const double length = round_length(0.2 * size.x());
  const Vector2d start = window.low + 0.03 * size;
  return {
      fmt::format(
          "set arrow 99 from {0:.6g},{1:.6g} to {2:.6g},{1:.6g} nohead lw 3 lc '#1c2126' front\n"
          "set label 99 '{3}' at {4:.6g},{5:.6g} center front tc '#1c2126'\n",
          start.x(), start.y(), start.x() + length, spoken_length(length), start.x() + 0.5 * length,
          start.y() + 0.025 * size.y()),
      ""};
}

PlotParts colour_bar(double end, const std::string& words) {
  return {ramp_palette() +
              fmt::format("set cbrange [0:{}]\nset cblabel '{}'\nset colorbox user origin screen "
                          "0.86,0.2 size screen 0.025,0.5\n$outside << EOD\n1e9 1e9 0\nEOD\n",
                          end, words),
          ", $outside using 1:2:3 with points palette notitle"};
}

PlotParts colour_names(const std::vector<ColouredName>& names) {
  PlotParts parts{
      fmt::format("set key at screen 0.84,{} left top reverse Left spacing 1.4 samplen 0.5\n",
                  legend_top),
      ""};
  for (const auto& [name, colour] : names)
    parts.plots +=
        fmt::format(", NaN with points pt 7 ps 2 lc rgb '{}' title \"{}\"", hex(colour), name);
  return parts;
}

PlotParts operator+(const PlotParts& first, const PlotParts& second) {
  return {first.settings + second.settings, first.plots + second.plots};
}

}  // namespace millwear::orchestrator
