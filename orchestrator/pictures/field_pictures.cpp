#include "orchestrator/pictures/field_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orchestrator/pictures/charge_spheres.h"
#include "orchestrator/pictures/gnuplot.h"
#include "orchestrator/pictures/section_plot.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double mm_per_m = 1e3;
constexpr double kw_per_w = 1e-3;
constexpr double seen_share = 0.002;  // what is occupied for less is left white

/// The values where the charge is for more than an instant.
VectorXd where_seen(const ChargeOfCycle& charge, const VectorXd& values) {
  const VectorXd& occupied = map_named(charge, "occupied").values;
  return (occupied.array() > seen_share).select(values.array(), std::nan(""));
}

/// The end of a scale: all but a thousandth of the values are below, rounded up to two digits.
double scale_end(const VectorXd& values) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known),
                       [](double value) { return std::isfinite(value) && value > 0.0; });
  if (known.empty()) return 1.0;
  const auto rank =
      known.begin() + static_cast<Index>(0.999 * static_cast<double>(known.size() - 1));
  std::ranges::nth_element(known, rank);
  const double digit = std::pow(10.0, std::floor(std::log10(*rank)) - 1.0);
  return digit * std::ceil(*rank / digit);
}

std::string image(const std::string& block) {
  return fmt::format("${} using 1:2:3 with image notitle", block);
}

/// A landmark's name beside a point.
std::string marked(const std::string& name, const Vector2d& place, int number) {
  if (!place.allFinite()) return "";
  return fmt::format(
      "set label {} '{}' at {:.5g},{:.5g} front boxed point pt 2 ps 1.4 lw 2 lc '#a8321c' offset "
      "1.2,0.9 tc '#1c2126'\n",
      number, name, place.x(), place.y());
}

/// A place on the circle of the crests; `angle` from three o'clock on the rising side.
Vector2d on_crests(const ChargeOfCycle& charge, double angle) {
  const double radius = 0.97 * charge.grid.half_width;
  const double from_six = angle - 1.5 * pi;
  return {-radius * std::sin(from_six), -radius * std::cos(from_six)};
}

std::string velocity_block(const ChargeOfCycle& charge, double fastest) {
  constexpr int every = 5;
  const VectorXd vx = where_seen(charge, map_named(charge, "velocity_x").values);
  const VectorXd vz = map_named(charge, "velocity_z").values;
  const auto& grid = charge.grid;
  const double scale = 1.6 * every * grid.cell_size() / fastest;
  std::string text = "$arrows << EOD\n";
  for (int row = every / 2; row < grid.cells; row += every)
    for (int column = every / 2; column < grid.cells; column += every) {
      const Index cell = column + Index{grid.cells} * row;
      if (!std::isfinite(vx[cell])) continue;
      text += fmt::format(
          "{:.5g} {:.5g} {:.5g} {:.5g}\n", (column + 0.5) * grid.cell_size() - grid.half_width,
          (row + 0.5) * grid.cell_size() - grid.half_width, scale * vx[cell], scale * vz[cell]);
    }
  return text + "EOD\n";
}

std::string track_block(const wear::ChargeFrames& frames) {
  constexpr std::size_t most_tracks = 6000;
  const std::size_t every = 1 + (frames.particles() - 1) / most_tracks;
  std::string text = "$tracks << EOD\n";
  for (std::size_t i = 0; i < frames.particles(); i += every) {
    for (std::size_t f = 0; f < frames.frames(); ++f) {
      const auto place = frames.place(f, i);
      fmt::format_to(std::back_inserter(text), "{:.5g} {:.5g} {:.3g}\n", place.x(), place.z(),
                     frames.speed_of(f, i));
    }
    text += "\n";
  }
  return text + "EOD\n";
}

}  // namespace

std::string occupancy_picture(const ChargeOfCycle& charge) {
  const auto& marks = charge.landmarks;
  const VectorXd occupied = map_named(charge, "occupied").values;
  return gnuplot_output(
      map_block("map", charge.grid, where_seen(charge, occupied)) + section_terminal(1) +
      marked("head", marks.head, 1) + marked("centre of circulation", marks.centre, 2) +
      marked("shoulder", on_crests(charge, marks.shoulder), 3) +
      marked("bulk toe", on_crests(charge, marks.bulk_toe), 4) +
      section_panel(charge, "occupied share of time [-]", 0.0, scale_end(occupied), image("map")));
}

std::string velocity_picture(const ChargeOfCycle& charge, double fastest) {
  const VectorXd speed = (map_named(charge, "velocity_x").values.array().square() +
                          map_named(charge, "velocity_z").values.array().square())
                             .sqrt();
  return gnuplot_output(
      map_block("map", charge.grid, where_seen(charge, speed)) + velocity_block(charge, fastest) +
      section_terminal(1) +
      section_panel(charge, "mean speed [m/s]", 0.0, fastest,
                    image("map") +
                        ", $arrows using 1:2:3:4 with vectors head size screen 0.006,20 lw 0.8 lc "
                        "'#ffffff' notitle"));
}

std::string collision_power_picture(const ChargeOfCycle& charge) {
  const bool recorded = std::ranges::any_of(
      charge.maps, [](const SectionMap& map) { return map.name == "normal_power"; });
  if (!recorded) return "";
  const VectorXd normal = kw_per_w * map_named(charge, "normal_power").values;
  const VectorXd shear = kw_per_w * map_named(charge, "shear_power").values;
  return gnuplot_output(
      map_block("normal", charge.grid, where_seen(charge, normal)) +
      map_block("shear", charge.grid, where_seen(charge, shear)) + section_terminal(2) +
      section_panel(charge, "normal to the contact [kW/m^3]", 0.0, scale_end(normal),
                    image("normal")) +
      section_panel(charge, "along the contact [kW/m^3]", 0.0, scale_end(shear), image("shear")));
}

std::string segregation_picture(const ChargeOfCycle& charge) {
  const VectorXd size = where_seen(charge, mm_per_m * map_named(charge, "mean_diameter").values);
  std::string blocks = map_block("size", charge.grid, size);
  const double smallest = size.array().isFinite().select(size.array(), 1e9).minCoeff();
  std::string panels =
      section_panel(charge, "mean diameter [mm]", smallest, scale_end(size), image("size"));
  int count = 1;
  for (const SectionMap& map : charge.maps) {
    constexpr std::string_view prefix = "share_of_";
    if (!map.name.starts_with(prefix)) continue;
    const std::string block = fmt::format("share{}", count++);
    blocks += map_block(block, charge.grid, where_seen(charge, map.values));
    panels += section_panel(charge,
                            fmt::format("share of {} by mass [-]", map.name.substr(prefix.size())),
                            0.0, 1.0, image(block));
  }
  return gnuplot_output(blocks + section_terminal(count) + panels);
}

ChargePicture streaks_picture(const ChargeOfCycle& charge, double fastest) {
  const std::string tracks = track_block(*charge.frames);
  const std::string panel =
      section_panel(charge, "speed [m/s]", 0.0, fastest,
                    "$tracks using 1:2:3 with lines lw 0.7 lc palette notitle");
  return {gnuplot_output(tracks + section_terminal(1) + panel),
          gnuplot_output(tracks + section_jpeg_terminal() + panel)};
}

}  // namespace millwear::orchestrator
