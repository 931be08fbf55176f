#include "orchestrator/pictures/plots.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mill/base/constants.h"
#include "mill/base/published_file.h"
#include "orchestrator/pictures/gnuplot.h"
#include "orchestrator/pictures/plot_style.h"
#include "orchestrator/results/measured_charge.h"

namespace millwear::orchestrator {
namespace {

constexpr double mm_per_m = 1e3;
constexpr double kw_per_w = 1e-3;

std::string profile_blocks(const std::vector<ProfileRow>& profiles) {
  std::string text = "$profiles << EOD\n";
  for (const auto& profile : profiles) {
    for (const auto& node : profile.nodes)
      text += fmt::format("{} {} {}\n", node.x() * mm_per_m, node.y() * mm_per_m,
                          profile.operating_hours);
    text += "\n";
  }
  return text + "EOD\n";
}

std::string height_block(const std::vector<HistoryRow>& history) {
  std::string text = "$height << EOD\n";
  for (const auto& row : history)
    text += fmt::format("{} {} {}\n", row.operating_hours, row.lifter_height * mm_per_m,
                        errors_of_95_percent * row.lifter_height_error * mm_per_m);
  return text + "EOD\n";
}

std::string power_block(const std::vector<MeasuredCharge>& charges) {
  std::string text = "$power << EOD\n";
  for (const auto& charge : charges)
    text += fmt::format("{} {} {}\n", charge.operating_hours, charge.power * kw_per_w,
                        std::isnan(charge.power_error) ? 0.0 : charge.power_error * kw_per_w);
  return text + "EOD\n";
}

/// Height of the picture [px] at which profiles drawn at equal scales fill its width.
int profile_picture_height(const std::vector<ProfileRow>& profiles) {
  constexpr double drawing_width = 900.0;
  constexpr double room_for_axis = 150.0;
  Eigen::AlignedBox2d extent;
  for (const auto& profile : profiles)
    for (const auto& node : profile.nodes) extent.extend(node);
  const Eigen::Vector2d sizes = extent.sizes();
  return static_cast<int>(std::clamp(drawing_width * sizes.y() / sizes.x(), 150.0, 1200.0) +
                          room_for_axis);
}

std::string profile_commands(const CampaignResults& data) {
  return plot_terminal(1200, profile_picture_height(data.profiles)) +
         profile_blocks(data.profiles) +
         "set size ratio -1\n"
         "set xlabel 'along the direction of rotation [mm]'\n"
         "set ylabel 'height over the new plate [mm]'\n"
         "set cblabel 'operating hours'\n"
         "set palette defined (0 '#16365c', 0.33 '#2c8a93', 0.66 '#d9a032', 1 '#a8321c')\n"
         "plot $profiles using 1:2:3 with lines lw 1.6 lc palette notitle\n";
}

std::string history_commands(const CampaignResults& data) {
  const auto charges = measured_charges(data.history);
  const bool has_power = std::ranges::any_of(
      charges, [](const MeasuredCharge& charge) { return std::isfinite(charge.power); });
  std::string text =
      plot_terminal(1200, has_power ? 800 : 450) + height_block(data.history) +
      power_block(charges) + "set xlabel 'operating hours'\nset lmargin 10\n" +
      fmt::format("set xrange [0:{}]\n", data.history.back().operating_hours * 1.02 + 1);
  if (has_power) text += "set multiplot layout 2,1\n";
  text +=
      "set ylabel 'lifter height [mm]'\nset yrange [0:*]\n"
      "plot $height using 1:($2-$3):($2+$3) with filledcurves fc '#aebfd0' title '95 % band',"
      " $height using 1:2 with linespoints lw 2 pt 7 ps 0.6 lc '#16365c' notitle\n";
  if (has_power)
    text +=
        "set ylabel 'power of the slice [kW]'\nset yrange [*:*]\n"
        "plot $power using 1:2 with lines lw 2 lc '#16365c' notitle,"
        " $power using 1:2:3 with yerrorbars pt 7 ps 0.6 lc '#16365c' notitle\n";
  return text;
}

}  // namespace

std::string plot_terminal(int width, int height) {
  return fmt::format(
      "set terminal pngcairo size {},{} font 'DejaVu Sans,11' background '#ffffff'\n"
      "set border 3 lc '#9aa4ad'\nset grid lc '#d9dee2' lt 1\nset tics nomirror tc '#1c2126'\n",
      width, height);
}

void write_plots(const CampaignResults& data, const std::filesystem::path& folder) {
  if (!data.profiles.empty())
    publish(folder / "profiles.png", gnuplot_output(profile_commands(data)));
  if (!data.history.empty())
    publish(folder / "history.png", gnuplot_output(history_commands(data)));
}

}  // namespace millwear::orchestrator
