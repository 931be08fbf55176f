#include "orchestrator/pictures/section_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mill/liner/profile_measures.h"
#include "orchestrator/pictures/colour_ramp.h"

namespace millwear::orchestrator {
namespace {

constexpr int panel_height = 540;    // px
constexpr int jpeg_side = 480;       // px
constexpr double least_span = 1e-6;  // of a scale: gnuplot draws no empty one

std::string panel_settings() {
  return "unset border\nunset xtics\nunset ytics\nset size ratio -1\nset samples 361\n"
         "set style textbox opaque noborder fillcolor '#ffffff' margins 0.6,0.6\n" +
         ramp_palette();
}

std::string circle(double radius) {
  return fmt::format(
      ", [t=0:2*pi] '+' using ({0:.6g}*cos($1)):({0:.6g}*sin($1)) with lines lw 1.5 lc "
      "'#5c6670' notitle",
      radius);
}

}  // namespace

std::string section_terminal(int panels) {
  return fmt::format(
             "set terminal pngcairo size {},{} font 'DejaVu Sans,11' background '#ffffff'\n",
             section_plot_width * panels, panel_height) +
         panel_settings() + fmt::format("set multiplot layout 1,{}\n", panels);
}

std::string section_jpeg_terminal() {
  return fmt::format("set terminal jpeg size {0},{0}\n", jpeg_side) + panel_settings() +
         "unset colorbox\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n";
}

std::string map_block(const std::string& name, const wear::SectionGrid& grid,
                      const Eigen::VectorXd& values) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double x = (static_cast<double>(i % grid.cells) + 0.5) * grid.cell_size();
    const double z = (static_cast<double>(i / grid.cells) + 0.5) * grid.cell_size();
    const std::string value = std::isfinite(values[i]) ? fmt::format("{:.4g}", values[i]) : "NaN";
    fmt::format_to(std::back_inserter(text), "{:.5g} {:.5g} {}\n", x - grid.half_width,
                   z - grid.half_width, value);
  }
  return text + "EOD\n";
}

std::string section_panel(const ChargeOfCycle& charge, const std::string& words, double low,
                          double end, const std::string& plots) {
  const double half = 1.02 * charge.liner.sector.shell_radius;
  return fmt::format(
             "set xrange [{0}:{1}]\nset yrange [{0}:{1}]\nset cbrange [{2}:{3}]\nset cblabel "
             "'{4}'\nplot ",
             -half, half, low, std::max(end, low + least_span), words) +
         plots + circle(charge.liner.sector.shell_radius) + circle(crest_radius(charge.liner)) +
         "\n";
}

}  // namespace millwear::orchestrator
