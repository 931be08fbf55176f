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

using Place = std::pair<ClipperLib::cInt, ClipperLib::cInt>;

Place place_of(const IntPoint& point) { return {point.X, point.Y}; }

Polygon polygon_of(const Grid& grid, const Path& path) {
  Polygon polygon;
  for (const IntPoint& point : path) polygon.push_back(grid.off(point));
  return polygon;
}

/// Takes the steel off that hangs on a single point: where the surface comes back to a point,
/// having gone around steel, which lies to its right.
void drop_hanging_pieces(const Grid& grid, Path& surface, std::vector<Polygon>& dropped) {
  std::map<Place, std::size_t> seen;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const auto [earlier, is_new] = seen.try_emplace(place_of(surface[i]), i);
    if (is_new) continue;
    const auto from = surface.begin() + static_cast<std::ptrdiff_t>(earlier->second);
    const auto to = surface.begin() + static_cast<std::ptrdiff_t>(i);
    const Path loop(from, to);
    if (ClipperLib::Area(loop) > 0.0) continue;  // a pocket
    if (area_of(loop) > least_piece) dropped.push_back(polygon_of(grid, loop));
    for (auto point = from + 1; point != to; ++point) seen.erase(place_of(*point));
    i = earlier->second;
    surface.erase(from, to);
  }
}

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
      if (area_of(piece) > least_piece) result.dropped.push_back(polygon_of(grid, piece));
      continue;
    }
    std::rotate(piece.begin(), start, piece.end());
    const auto end = std::find(piece.begin(), piece.end(), last);
    if (end == piece.end()) break;
    Path left(piece.begin() + 1, end);
    drop_hanging_pieces(grid, left, result.dropped);
    result.surface = polygon_of(grid, left);
  }
  if (result.surface.empty()) {
    throw ResultRejected(
        "the load takes more steel than there is under the profile; shorten the step");
  }

  std::map<Place, Eigen::Vector2d> old_nodes;
  for (const auto& node : surface) old_nodes.emplace(place_of(grid.on(node)), node);
  for (auto& node : result.surface) {
    const auto old = old_nodes.find(place_of(grid.on(node)));
    if (old != old_nodes.end()) node = old->second;
  }
  return result;
}

}  // namespace millwear::wear
