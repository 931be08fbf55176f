#include "wear/gauge/area_between.h"

#include <clipper.hpp>
#include <cmath>

#include "mill/base/failure.h"
#include "wear/evolve/steel_cut.h"

namespace millwear::wear {
namespace {

/// The open side of the pitch: between the profile and the mill's axis.
ClipperLib::Path open_side(const LinerProfile& profile) {
  ClipperLib::Path path;
  const auto add = [&](const Eigen::Vector2d& point) {
    path.emplace_back(std::llround(point.x() / clipping_grid),
                      std::llround(point.y() / clipping_grid));
  };
  for (const auto& node : profile.nodes) add(node);
  add({0.0, profile.sector.plate_radius});
  return path;
}

}  // namespace

double area_between(const LinerProfile& a, const LinerProfile& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPath(open_side(a), ClipperLib::ptSubject, true);
  clipper.AddPath(open_side(b), ClipperLib::ptClip, true);
  ClipperLib::Paths pieces;
  if (!clipper.Execute(ClipperLib::ctXor, pieces, ClipperLib::pftNonZero, ClipperLib::pftNonZero))
    throw ResultRejected("the area between two profiles cannot be found: Clipper failed");
  double area = 0.0;
  for (const auto& piece : pieces) area += ClipperLib::Area(piece);
  return std::abs(area) * clipping_grid * clipping_grid;
}

}  // namespace millwear::wear
