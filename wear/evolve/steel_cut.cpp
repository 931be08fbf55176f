#include "wear/evolve/steel_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Smaller pieces are slivers of the grid, not steel that falls off [m2].
constexpr double least_piece = 1e-10;

/// Clipper may take a cut under an edge along its sweep line, such as the flat top of a lifter, for
/// a hole in the steel. So it sees the steel turned, by the first of these angles [rad] at which it
/// finds no hole: a cut always opens on the surface.
constexpr double turns[] = {0.4321, 1.0987, 0.7654};

/// Clipper's frame: turned, and in whole steps of the grid.
class Grid {
 public:
  explicit Grid(double turn) : turn_(turn) {}

  [[nodiscard]] IntPoint on(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d turned = turn_ * point / clipping_grid;
    return {std::llround(turned.x()), std::llround(turned.y())};
  }

  [[nodiscard]] Eigen::Vector2d off(const IntPoint& point) const {
    const Eigen::Vector2d turned(static_cast<double>(point.X), static_cast<double>(point.Y));
    return clipping_grid * (turn_.inverse() * turned);
  }

  [[nodiscard]] Path path_of(const Polygon& polygon) const {
    Path path;
    path.reserve(polygon.size());
    for (const auto& point : polygon) path.push_back(on(point));
    if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
    return path;
  }

 private:
  Eigen::Rotation2Dd turn_;
};

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

bool is_hole(const Path& piece) { return !ClipperLib::Orientation(piece); }

struct Remains {
  Grid grid;
  Paths pieces;
};

Remains remains_of(const Polygon& steel, const std::vector<Polygon>& swept) {
  for (const double turn : turns) {
    const Grid grid(turn);
    Paths clips;
    for (const Polygon& polygon : swept) clips.push_back(grid.path_of(polygon));
    Paths pieces = difference(grid.path_of(steel), clips);
    const bool has_hole = std::any_of(pieces.begin(), pieces.end(), [](const Path& piece) {
      return is_hole(piece) && area_of(piece) > least_piece;
    });
    if (!has_hole) return {grid, std::move(pieces)};
  }
  throw ResultRejected("the worn steel cannot be cut off the profile: Clipper finds a hole in it");
}

}  // namespace

SteelCut cut(const std::vector<Eigen::Vector2d>& surface,
             const std::vector<Eigen::Vector2d>& bottom, const std::vector<Polygon>& swept) {
  Polygon steel = surface;
  steel.insert(steel.end(), bottom.rbegin(), bottom.rend());
  auto [grid, pieces] = remains_of(steel, swept);

  const IntPoint first = grid.on(bottom.front());
  const IntPoint last = grid.on(bottom.back());
  SteelCut result{{}, {}};
  for (Path& piece : pieces) {
    if (is_hole(piece)) continue;
    ClipperLib::ReversePath(piece);
    const auto start = std::find(piece.begin(), piece.end(), first);
    if (start == piece.end()) {
      if (area_of(piece) > least_piece) {
        Polygon& dropped = result.dropped.emplace_back();
        for (const IntPoint& point : piece) dropped.push_back(grid.off(point));
      }
      continue;
    }
    std::rotate(piece.begin(), start, piece.end());
    const auto end = std::find(piece.begin(), piece.end(), last);
    if (end == piece.end()) break;
    for (auto point = piece.begin() + 1; point != end; ++point)
      result.surface.push_back(grid.off(*point));
  }
  if (result.surface.empty()) {
    throw ResultRejected(
        "the load takes more steel than there is under the profile; shorten the step");
  }

  std::map<std::pair<ClipperLib::cInt, ClipperLib::cInt>, Eigen::Vector2d> old_nodes;
  for (const auto& node : surface) {
    const IntPoint place = grid.on(node);
    old_nodes.emplace(std::pair(place.X, place.Y), node);
  }
  for (auto& node : result.surface) {
    const IntPoint place = grid.on(node);
    const auto old = old_nodes.find({place.X, place.Y});
    if (old != old_nodes.end()) node = old->second;
  }
  return result;
}

}  // namespace millwear::wear
