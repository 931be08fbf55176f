#include "orchestrator/pictures/liner_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "mill/base/constants.h"
#include "mill/liner/mill_frame.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/pictures/gnuplot.h"

namespace millwear::orchestrator {
namespace {

constexpr int width = 1280;  // px
constexpr int height = 640;  // px
constexpr double mm = 1e3;   // in a metre
constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr const char* steel = "#9aa5b1";
constexpr const char* ink = "#1f2933";

using Points = std::vector<Eigen::Vector2d>;

std::string block(const std::string& name, const Points& points) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const Eigen::Vector2d& point : points)
    fmt::format_to(std::back_inserter(text), "{:.6g} {:.6g}\n", point.x(), point.y());
  return text + "EOD\n";
}

Points ring_of(const LinerProfile& liner) {
  Points ring;
  for (int row = 0; row < liner.sector.rows; ++row)
    for (const Eigen::Vector2d& node : liner.nodes)
      ring.push_back(to_mill(liner.sector, node, row, 0.0));
  ring.push_back(ring.front());
  return ring;
}

/// The steel of one pitch [mm]: the surface and, back, the shell.
Points steel_of_pitch(const LinerProfile& liner) {
  const double edge = 0.5 * liner.sector.pitch();
  Points steel_section;
  for (const Eigen::Vector2d& node : liner.nodes) steel_section.push_back(mm * node);
  const auto shell = nodes_between(liner.sector, liner.sector.shell_radius, -edge, edge);
  steel_section.push_back(mm * point_at(liner.sector, liner.sector.shell_radius, edge));
  for (auto node = shell.rbegin(); node != shell.rend(); ++node)
    steel_section.push_back(mm * *node);
  steel_section.push_back(mm * point_at(liner.sector, liner.sector.shell_radius, -edge));
  steel_section.push_back(steel_section.front());
  return steel_section;
}

/// The place of the surface that is nearest to the mill's axis [m].
Eigen::Vector2d crest(const LinerProfile& liner) {
  return *std::ranges::min_element(
      liner.nodes, {}, [&](const Eigen::Vector2d& node) { return radius_of(liner.sector, node); });
}

struct Ball {
  Eigen::Vector2d centre;  ///< [mm]
  double radius;           ///< [mm]
};

/// Diameters of the classes [mm], largest first, each once.
std::vector<double> diameters_of(const Charge& charge) {
  std::vector<double> diameters;
  for (const ParticleClass& kind : charge.classes) diameters.push_back(mm * kind.diameter);
  std::ranges::sort(diameters, std::ranges::greater{});
  const auto again = std::ranges::unique(diameters);
  diameters.erase(again.begin(), again.end());
  return diameters;
}

/// Classes side by side in `room` [mm], standing on `floor` [mm]; the smallest is always there.
std::vector<Ball> balls_beside(std::vector<double> diameters, double room, double floor) {
  constexpr double gap = 1.25;  // of a diameter
  const auto needed = [&] {
    double sum = 0.0;
    for (const double diameter : diameters) sum += gap * diameter;
    return sum;
  };
  while (diameters.size() > 2 && needed() > room) diameters.erase(diameters.end() - 2);
  std::vector<Ball> balls;
  double at = -0.5 * needed();
  for (const double diameter : diameters) {
    balls.push_back({{at + 0.5 * gap * diameter, floor + 0.5 * diameter}, 0.5 * diameter});
    at += gap * diameter;
  }
  return balls;
}

std::string terminal(DrawingFormat format) {
  return format == DrawingFormat::svg
             ? fmt::format(
                   "set terminal svg size {},{} font 'DejaVu Sans,13' background '#ffffff' "
                   "noenhanced\n",
                   width, height)
             : fmt::format(
                   "set terminal pngcairo size {},{} font 'DejaVu Sans,11' background "
                   "'#ffffff' noenhanced\n",
                   width, height);
}

std::string arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const char* heads) {
  return fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} {} lc '{}' front\n", from.x(),
                     from.y(), to.x(), to.y(), heads, ink);
}

std::string label(const std::string& words, const Eigen::Vector2d& at, const char* side) {
  return fmt::format("set label '{}' at {:.6g},{:.6g} {} front tc '{}'\n", words, at.x(), at.y(),
                     side, ink);
}

std::string panel(double left, double right, const Eigen::Vector2d& low,
                  const Eigen::Vector2d& high) {
  return fmt::format(
      "unset arrow\nunset label\nunset object\nset lmargin at screen {}\nset rmargin at screen {}\n"
      "set bmargin at screen 0.05\nset tmargin at screen 0.93\n"
      "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n",
      left, right, low.x(), high.x(), low.y(), high.y());
}

std::string mill_panel(const Case& mill) {
  const LinerSector& sector = mill.liner.sector;
  const double half = 1.05 * sector.shell_radius;
  std::string text = panel(0.02, 0.46, {-half, -half}, {half, half});
  text +=
      fmt::format("set title '{}: {:.4g} m inside the shell, {} lifters, {:.4g} rpm'\n", mill.name,
                  2.0 * sector.shell_radius, sector.rows, mill.speed * 60.0 / full_turn);
  text += fmt::format(
      "set object circle at 0,0 size first {:.6g} fillstyle solid noborder fillcolor '{}' back\n",
      sector.shell_radius, steel);
  // The mill turns clockwise: the rising side is on the left.
  const double radius = 0.45 * sector.shell_radius;
  text += block("ring", ring_of(mill.liner));
  text += arrow({0.0, radius}, {0.12 * radius, radius}, "head filled size screen 0.012,22 lw 2");
  text += fmt::format(
      "plot $ring using 1:2 with filledcurves closed fillcolor '#ffffff' notitle, $ring using 1:2 "
      "with lines lw 1 lc '{0}' notitle, [t=0.5*pi:1.4*pi] '+' using "
      "({1:.6g}*cos($1)):({1:.6g}*sin($1)) "
      "with lines lw 2 lc '{0}' notitle\n",
      ink, radius);
  return text;
}

std::string dimensions(const Case& mill, double bottom) {
  const LinerProfile& liner = mill.liner;
  const LinerSector& sector = liner.sector;
  const double edge = 0.5 * sector.pitch();
  const Eigen::Vector2d top = mm * crest(liner);
  const double tall = mm * lifter_height(liner);
  const Eigen::Vector2d left = mm * liner.nodes.front();
  const Eigen::Vector2d shell_left = mm * point_at(sector, sector.shell_radius, -edge);
  const Eigen::Vector2d right = mm * liner.nodes.back();
  constexpr const char* both = "heads filled size screen 0.006,20 lw 1.2";
  std::string text;
  const Eigen::Vector2d foot(top.x(), top.y() - tall);
  text += arrow(foot, top, both);
  text += label(fmt::format(" {:.1f} mm", tall), 0.5 * (foot + top), "left");
  text += arrow(shell_left, left, both);
  text += label(fmt::format(" plate {:.1f} mm", mm * plate_thickness(liner)),
                0.5 * (shell_left + left), "left");
  text += arrow({left.x(), bottom}, {right.x(), bottom}, both);
  text +=
      label(fmt::format("pitch {:.1f} mm on the plate", mm * sector.pitch() * sector.plate_radius),
            {0.0, bottom}, "center offset 0,0.7");
  const double angle = degrees_per_radian * leading_face_angle(liner);
  text += label(fmt::format("leading face {:.1f} deg", angle), {0.5 * right.x(), 0.75 * top.y()},
                "left");
  return text;
}

std::string pitch_panel(const Case& mill) {
  const LinerProfile& liner = mill.liner;
  const Points section = steel_of_pitch(liner);
  const auto low_high = [&](auto member) {
    const auto [low, high] = std::ranges::minmax(section, {}, member);
    return std::pair(low, high);
  };
  const auto across = low_high([](const Eigen::Vector2d& p) { return p.x(); });
  const auto up = low_high([](const Eigen::Vector2d& p) { return p.y(); });
  const double wide = across.second.x() - across.first.x();
  const double bottom = up.first.y() - 0.06 * wide;
  const auto balls = balls_beside(diameters_of(mill.charge), wide, up.second.y() + 0.03 * wide);
  const double ball_top = balls.front().centre.y() + balls.front().radius;
  std::string text = panel(0.5, 0.98, {across.first.x() - 0.05 * wide, bottom - 0.06 * wide},
                           {across.second.x() + 0.05 * wide, ball_top + 0.08 * wide});
  text += "set title 'One pitch, to scale; the direction of rotation is to the right'\n";
  text += block("steel", section) + dimensions(mill, bottom);
  for (const Ball& ball : balls) {
    text += fmt::format(
        "set object circle at {:.6g},{:.6g} size first {:.6g} fillstyle solid border lc '{}' "
        "fillcolor '#e3c9a0' front\n",
        ball.centre.x(), ball.centre.y(), ball.radius, ink);
    text += label(fmt::format("{:.4g} mm", 2.0 * ball.radius),
                  {ball.centre.x(), ball.centre.y() + ball.radius}, "center offset 0,0.6");
  }
  text += fmt::format(
      "plot $steel using 1:2 with filledcurves closed fillcolor '{}' notitle, $steel using 1:2 "
      "with "
      "lines lw 1.5 lc '{}' notitle\n",
      steel, ink);
  return text;
}

}  // namespace

std::string liner_drawing(const Case& mill, DrawingFormat format) {
  return gnuplot_output(terminal(format) +
                        "set multiplot\nunset border\nunset tics\nset size ratio -1\n" +
                        mill_panel(mill) + pitch_panel(mill) + "unset multiplot\n");
}

}  // namespace millwear::orchestrator
