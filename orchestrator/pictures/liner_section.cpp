#include "orchestrator/pictures/liner_section.h"

#include <cmath>

#include "mill/liner/mill_frame.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Rgb surface_colour{0.62, 0.66, 0.70};
const Rgb cut_colour{0.42, 0.46, 0.50};

/// The profile of one row, along the rotation.
Outline row_outline(const LinerProfile& liner, int row, double mill_angle) {
  Outline places;
  for (const Vector2d& node : liner.nodes)
    places.push_back(to_mill(liner.sector, node, row, mill_angle));
  return places;
}

Vector2d on_shell(const LinerProfile& liner, const Vector2d& place) {
  return place * (liner.sector.shell_radius / place.norm());
}

Vector3d at(const Vector2d& place, double y) { return {place.x(), y, place.y()}; }

void add_quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
              const Rgb& colour, std::vector<Triangle>& triangles) {
  triangles.push_back({{a, b, c}, colour});
  triangles.push_back({{a, c, d}, colour});
}

}  // namespace

std::vector<Outline> steel_outlines(const LinerProfile& liner, double mill_angle) {
  constexpr int arc_points = 12;
  std::vector<Outline> outlines;
  for (int row = 0; row < liner.sector.rows; ++row) {
    Outline outline = row_outline(liner, row, mill_angle);
    const double first = angle_from_six_oclock(outline.front().x(), outline.front().y());
    const double pitch = liner.sector.pitch();
    for (int i = arc_points; i >= 0; --i) {
      const double angle = first + pitch * i / arc_points;
      outline.push_back(-liner.sector.shell_radius * Vector2d(std::sin(angle), std::cos(angle)));
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Triangle> cut_liner(const LinerProfile& liner, double mill_angle, double length) {
  std::vector<Triangle> triangles;
  for (int row = 0; row < liner.sector.rows; ++row) {
    const Outline places = row_outline(liner, row, mill_angle);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Vector2d& a = places[i];
      const Vector2d& b = places[i + 1];
      add_quad(at(a, 0.0), at(b, 0.0), at(b, length), at(a, length), surface_colour, triangles);
      add_quad(at(a, 0.0), at(b, 0.0), at(on_shell(liner, b), 0.0), at(on_shell(liner, a), 0.0),
               cut_colour, triangles);
    }
  }
  return triangles;
}

}  // namespace millwear::orchestrator
