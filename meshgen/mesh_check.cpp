#include "meshgen/mesh_check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"

namespace millwear::meshgen {
namespace {

constexpr double rounding = 1e-9;      ///< a share by which a limit may be missed
constexpr double same_place = 1e-9;    ///< [m]; LIGGGHTS joins nodes within 1e-8 m
constexpr double same_length = 1e-12;  ///< [m]; LIGGGHTS warns of nodes outside its box

using Segment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

Eigen::Vector2d section_of(const Eigen::Vector3d& vertex) { return {vertex.x(), vertex.z()}; }

Eigen::Vector3d area_vector(const LinerMesh& mesh, const Triangle& t) {
  const Eigen::Vector3d& corner = mesh.vertices[t[0]];
  return 0.5 * (mesh.vertices[t[1]] - corner).cross(mesh.vertices[t[2]] - corner);
}

double smallest_angle(const LinerMesh& mesh, const Triangle& t) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 3; ++corner) {
    const Eigen::Vector3d a = mesh.vertices[t[(corner + 1) % 3]] - mesh.vertices[t[corner]];
    const Eigen::Vector3d b = mesh.vertices[t[(corner + 2) % 3]] - mesh.vertices[t[corner]];
    smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return smallest;
}

bool on_rim(const LinerMesh& mesh, int a, int b, double y) {
  return std::abs(mesh.vertices[a].y() - y) <= same_length &&
         std::abs(mesh.vertices[b].y() - y) <= same_length;
}

/// Edges that one triangle alone has.
std::vector<std::pair<int, int>> open_edges(const LinerMesh& mesh) {
  std::map<std::pair<int, int>, std::size_t> triangle_of_edge;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    for (int corner = 0; corner < 3; ++corner) {
      const auto [place, is_new] = triangle_of_edge.insert({{t[corner], t[(corner + 1) % 3]}, i});
      if (!is_new) {
        throw ResultRejected(fmt::format(
            "liner mesh: triangles {} and {} run the same edge in the same sense; a surface has "
            "each edge once in each",
            place->second, i));
      }
    }
  }
  std::vector<std::pair<int, int>> open;
  for (const auto& [edge, triangle] : triangle_of_edge) {
    if (!triangle_of_edge.contains({edge.second, edge.first})) {
      open.push_back(edge);
    }
  }
  return open;
}

void check_rims(const LinerMesh& mesh) {
  std::vector<Segment> near_rim;
  std::vector<Segment> far_rim;
  for (const auto& [a, b] : open_edges(mesh)) {
    const Segment segment{section_of(mesh.vertices[a]), section_of(mesh.vertices[b])};
    if (on_rim(mesh, a, b, 0.0)) {
      near_rim.push_back(segment);
    } else if (on_rim(mesh, a, b, mesh.slice_length)) {
      far_rim.emplace_back(segment.second, segment.first);
    } else {
      throw ResultRejected(fmt::format(
          "liner mesh: it has a hole at ({:.6g}, {:.6g}, {:.6g}) m; only the rims at y = 0 and "
          "{:.6g} m may be open",
          mesh.vertices[a].x(), mesh.vertices[a].y(), mesh.vertices[a].z(), mesh.slice_length));
    }
  }
  const auto match = [&](const Segment& s) {
    return std::ranges::any_of(far_rim, [&](const Segment& t) {
      return (s.first - t.first).norm() <= same_place && (s.second - t.second).norm() <= same_place;
    });
  };
  const std::size_t expected = static_cast<std::size_t>(mesh.rows) * mesh.facets_per_lifter;
  if (near_rim.size() != expected || far_rim.size() != expected ||
      !std::ranges::all_of(near_rim, match)) {
    throw ResultRejected(fmt::format(
        "liner mesh: its rims have {} and {} edges where {} are due, or are not the same line; "
        "LIGGGHTS joins them through the periodic boundary",
        near_rim.size(), far_rim.size(), expected));
  }
}

void check_normals(const LinerMesh& mesh) {
  double inward = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector2d place = section_of(mesh.vertices[t[0]]);
    inward -= section_of(area_vector(mesh, t)).dot(place);
  }
  if (!(inward > 0.0)) {
    throw ResultRejected("liner mesh: its normals look into the steel; they must face the charge");
  }
}

double distance(const Eigen::Vector2d& point, const Segment& segment) {
  const Eigen::Vector2d chord = segment.second - segment.first;
  const double along =
      std::clamp((point - segment.first).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
  return (point - segment.first - along * chord).norm();
}

double distance(const Eigen::Vector2d& point, const std::vector<Segment>& line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& segment : line) {
    nearest = std::min(nearest, distance(point, segment));
  }
  return nearest;
}

/// A triangle of the liner seen along the axis is the facet that it lies on.
Segment facet_of(const LinerMesh& mesh, const Triangle& t) {
  const Eigen::Vector2d a = section_of(mesh.vertices[t[0]]);
  const Eigen::Vector2d b = section_of(mesh.vertices[t[1]]);
  const Eigen::Vector2d c = section_of(mesh.vertices[t[2]]);
  return (a - b).norm() > (a - c).norm() ? Segment{a, b} : Segment{a, c};
}

std::vector<Segment> profile_on_lifter(const LinerProfile& profile, int lifter) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < profile.nodes.size(); ++i) {
    segments.emplace_back(to_mill(profile.sector, profile.nodes[i - 1], lifter, 0.0),
                          to_mill(profile.sector, profile.nodes[i], lifter, 0.0));
  }
  return segments;
}

/// How far the mesh lies from the profile on its lifters, at nodes of both and facets' middles [m].
double largest_deviation(const LinerMesh& mesh, const LinerProfile& profile) {
  std::vector<std::vector<Segment>> facets(mesh.rows);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    facets[address_of(mesh, i).lifter].push_back(facet_of(mesh, mesh.triangles[i]));
  }
  double largest = 0.0;
  for (int lifter = 0; lifter < mesh.rows; ++lifter) {
    const auto steel = profile_on_lifter(profile, lifter);
    for (const auto& [start, end] : facets[lifter]) {
      largest = std::max({largest, distance(start, steel), distance(end, steel),
                          distance(0.5 * (start + end), steel)});
    }
    for (const auto& [start, end] : steel) {
      largest = std::max({largest, distance(start, facets[lifter]), distance(end, facets[lifter])});
    }
  }
  return largest;
}

}  // namespace

MeshReport check_mesh(const LinerMesh& mesh, const LinerProfile& profile,
                      const MeshSettings& settings) {
  MeshReport report{mesh.triangles.size(), std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const double angle = smallest_angle(mesh, mesh.triangles[i]);
    if (!(angle >= settings.smallest_angle * (1.0 - rounding))) {
      throw ResultRejected(
          fmt::format("liner mesh: triangle {} has an angle of {:.3g} degrees; the limit is {:.3g}",
                      i, angle * degrees_per_radian, settings.smallest_angle * degrees_per_radian));
    }
    report.smallest_angle = std::min(report.smallest_angle, angle);
    report.area += area_vector(mesh, mesh.triangles[i]).norm();
  }
  check_rims(mesh);
  check_normals(mesh);
  report.largest_deviation = largest_deviation(mesh, profile);
  if (!(report.largest_deviation <= settings.tolerance * (1.0 + rounding))) {
    throw ResultRejected(fmt::format(
        "liner mesh: it lies up to {:.3g} m from the profile; the tolerance is {:.3g} m",
        report.largest_deviation, settings.tolerance));
  }
  return report;
}

}  // namespace millwear::meshgen
