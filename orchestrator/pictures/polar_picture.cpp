#include "orchestrator/pictures/polar_picture.h"

#include <fmt/format.h>

#include <iterator>

#include "orchestrator/pictures/colour_ramp.h"
#include "orchestrator/pictures/gnuplot.h"

namespace millwear::orchestrator {
namespace {

constexpr double mm_per_m = 1e3;
constexpr double least_shown = 0.1;  // times the mean; the scale is logarithmic
constexpr double degrees_a_column = 360.0 / wear::polar_columns;

constexpr std::array<const char*, wear::polar_measures.size()> titles{
    "contacts", "energy dissipated normal to the liner", "sliding work"};

/// Angle from three o'clock on the rising side of a column's middle, which runs from six o'clock
/// backwards: 90 (twelve o'clock) to 450 degrees.
double degrees(Eigen::Index column) {
  return 90.0 + (static_cast<double>(column) + 0.5) * degrees_a_column;
}

std::string block_of(std::size_t measure, const Eigen::MatrixXd& values,
                     const LoadAlongProfile& along) {
  const double mean = values.mean();
  std::string text = fmt::format("$map{} << EOD\n", measure);
  for (Eigen::Index bin = 0; bin < values.rows(); ++bin) {
    for (Eigen::Index column = 0; column < values.cols(); ++column)
      fmt::format_to(std::back_inserter(text), "{:.5g} {:.5g} {:.4g}\n", degrees(column),
                     mm_per_m * along.arc_length[static_cast<std::size_t>(bin)],
                     mean > 0.0 ? values(bin, column) / mean : 0.0);
  }
  return text + "EOD\n";
}

}  // namespace

std::string polar_picture(const wear::PolarLoad& load, const LoadAlongProfile& along) {
  std::string blocks;
  std::string panels;
  for (std::size_t m = 0; m < titles.size(); ++m) {
    const double most = load.values[m].maxCoeff() / load.values[m].mean();
    blocks += block_of(m, load.values[m], along);
    panels += fmt::format(
        "set title '{}'\nset cbrange [{}:{}]\nplot $map{} using 1:2:3 with image "
        "notitle\n",
        titles[m], least_shown, most > 1.0 ? most : 1.0, m);
  }
  return gnuplot_output(
      blocks +
      "set terminal pngcairo size 1500,560 font 'DejaVu Sans,11' background '#ffffff'\n"
      "set border 3 lc '#9aa4ad'\nset tics nomirror tc '#1c2126'\n" +
      ramp_palette() +
      "set xrange [90:450]\nset xtics 90\n"
      "set xlabel 'angle [degrees]; twelve o''clock 90, six 270'\n"
      "set ylabel 'along the profile [mm]'\nset autoscale y\nset cblabel 'times the mean'\n"
      "set logscale cb\nset multiplot layout 1,3\n" +
      panels);
}

}  // namespace millwear::orchestrator
