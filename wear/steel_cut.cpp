#include "wear/steel_cut.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <map>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Smaller pieces are slivers of the grid, not steel that falls off [m2].
constexpr double least_piece = 1e-10;

IntPoint on_grid(const Eigen::Vector2d& point) {
  return {std::llround(point.x() / clipping_grid), std::llround(point.y() / clipping_grid)};
}

Eigen::Vector2d off_grid(const IntPoint& point) {
  return {static_cast<double>(point.X) * clipping_grid,
          static_cast<double>(point.Y) * clipping_grid};
}

Path path_of(const Polygon& polygon) {
  Path path;
  path.reserve(polygon.size());
  std::transform(polygon.begin(), polygon.end(), std::back_inserter(path), on_grid);
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

Paths difference(const Path& subject, const Paths& clips) {
  ClipperLib::Clipper clipper;
  clipper.PreserveCollinear(true);
  clipper.AddPath(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clips, ClipperLib::ptClip, true);
  Paths result;
  if (!clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero,
                       ClipperLib::pftNonZero)) {
    throw ResultRejected("the worn steel cannot be cut off the profile: Clipper failed");
  }
  return result;
}

double area_of(const Path& path) {
  return std::abs(ClipperLib::Area(path)) * clipping_grid * clipping_grid;
}

}  // namespace

SteelCut cut(const std::vector<Eigen::Vector2d>& surface,
             const std::vector<Eigen::Vector2d>& bottom, const std::vector<Polygon>& swept) {
  Polygon steel = surface;
  steel.insert(steel.end(), bottom.rbegin(), bottom.rend());
  Paths clips;
  clips.reserve(swept.size());
  std::transform(swept.begin(), swept.end(), std::back_inserter(clips), path_of);

  const IntPoint first = on_grid(bottom.front());
  const IntPoint last = on_grid(bottom.back());
  SteelCut result{{}, {}};
  for (Path& piece : difference(path_of(steel), clips)) {
    const bool is_hole = !ClipperLib::Orientation(piece);
    if (is_hole) continue;
    ClipperLib::ReversePath(piece);
    const auto start = std::find(piece.begin(), piece.end(), first);
    if (start == piece.end()) {
      if (area_of(piece) > least_piece) {
        std::transform(piece.begin(), piece.end(),
                       std::back_inserter(result.dropped.emplace_back()), off_grid);
      }
      continue;
    }
    std::rotate(piece.begin(), start, piece.end());
    const auto end = std::find(piece.begin(), piece.end(), last);
    if (end == piece.end()) break;
    std::transform(piece.begin() + 1, end, std::back_inserter(result.surface), off_grid);
  }
  if (result.surface.empty()) {
    throw ResultRejected("the load takes more steel than there is under the profile");
  }

  std::map<std::pair<ClipperLib::cInt, ClipperLib::cInt>, Eigen::Vector2d> old_nodes;
  for (const auto& node : surface) {
    const IntPoint place = on_grid(node);
    old_nodes.emplace(std::pair(place.X, place.Y), node);
  }
  for (auto& node : result.surface) {
    const IntPoint place = on_grid(node);
    const auto old = old_nodes.find({place.X, place.Y});
    if (old != old_nodes.end()) node = old->second;
  }
  return result;
}

}  // namespace millwear::wear
