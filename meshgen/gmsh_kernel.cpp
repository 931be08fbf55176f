#include "meshgen/gmsh_kernel.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <mutex>
#include <numeric>
#include <sstream>
#include <string>
#include <unordered_map>

#include "mill/base/constants.h"
#include "mill/base/failure.h"

namespace millwear::meshgen {
namespace {

constexpr int triangle_type = 2;

class GmshSession {
 public:
  GmshSession() : lock_(mutex()) {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.AbortOnError", 1);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::option::setNumber("Mesh.Binary", 0);
    gmsh::model::add("liner");
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex the_mutex;
    return the_mutex;
  }
  std::lock_guard<std::mutex> lock_;
};

/// OpenCASCADE reports what it writes on std::cout, which is for our results.
class QuietOutput {
 public:
  QuietOutput() : before_(std::cout.rdbuf(swallowed_.rdbuf())) {}
  ~QuietOutput() { std::cout.rdbuf(before_); }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

 private:
  std::ostringstream swallowed_;
  std::streambuf* before_;
};

/// gmsh throws std::string, and some of its failures only leave a message.
template <class Work>
auto with_gmsh(const char* purpose, Work&& work) {
  const GmshSession session;
  const QuietOutput quiet;
  try {
    auto result = work();
    std::string error;
    gmsh::logger::getLastError(error);
    if (!error.empty()) {
      throw error;
    }
    return result;
  } catch (const std::string& error) {
    throw ExternalProgramError(fmt::format("gmsh could not {}: {}", purpose, error));
  }
}

/// Side i of the polygon swept as one four-sided surface, tag i + 1, its normal to the inside.
void add_swept_sides(const std::vector<Eigen::Vector2d>& corners, double length, int layers) {
  namespace geo = gmsh::model::geo;
  const int count = static_cast<int>(corners.size());
  const auto near_point = [](int corner) { return corner + 1; };
  const auto far_point = [count](int corner) { return count + corner + 1; };
  const auto near_line = [](int side) { return side + 1; };
  const auto far_line = [count](int side) { return count + side + 1; };
  const auto axial_line = [count](int corner) { return 2 * count + corner + 1; };

  for (int i = 0; i < count; ++i) {
    geo::addPoint(corners[i].x(), 0.0, corners[i].y(), 0.0, near_point(i));
    geo::addPoint(corners[i].x(), length, corners[i].y(), 0.0, far_point(i));
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    geo::addLine(near_point(i), near_point(next), near_line(i));
    geo::addLine(far_point(i), far_point(next), far_line(i));
    geo::addLine(near_point(i), far_point(i), axial_line(i));
    geo::mesh::setTransfiniteCurve(near_line(i), 2);
    geo::mesh::setTransfiniteCurve(far_line(i), 2);
    geo::mesh::setTransfiniteCurve(axial_line(i), layers + 1);
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    geo::addCurveLoop({axial_line(i), far_line(i), -axial_line(next), -near_line(i)}, i + 1);
    geo::addPlaneSurface({i + 1}, i + 1);
    geo::mesh::setTransfiniteSurface(i + 1);
  }
  geo::synchronize();
}

std::vector<Triangle> triangles_along_y(int surface,
                                        const std::unordered_map<std::size_t, int>& index_of_tag,
                                        const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::size_t> element_tags;
  std::vector<std::size_t> node_tags;
  gmsh::model::mesh::getElementsByType(triangle_type, element_tags, node_tags, surface);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < node_tags.size(); i += 3) {
    triangles.push_back({index_of_tag.at(node_tags[i]), index_of_tag.at(node_tags[i + 1]),
                         index_of_tag.at(node_tags[i + 2])});
  }
  std::ranges::stable_sort(triangles, {}, [&](const Triangle& t) {
    return vertices[t[0]].y() + vertices[t[1]].y() + vertices[t[2]].y();
  });
  return triangles;
}

Triangulation read_mesh(int surfaces) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  Triangulation mesh;
  std::unordered_map<std::size_t, int> index_of_tag;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index_of_tag[tags[i]] = static_cast<int>(i);
    mesh.vertices.emplace_back(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
  }
  for (int surface = 1; surface <= surfaces; ++surface) {
    std::ranges::copy(triangles_along_y(surface, index_of_tag, mesh.vertices),
                      std::back_inserter(mesh.triangles));
  }
  return mesh;
}

void add_discrete_surface(const Triangulation& surface) {
  std::vector<std::size_t> node_tags(surface.vertices.size());
  std::iota(node_tags.begin(), node_tags.end(), std::size_t{1});
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    coordinates.insert(coordinates.end(), vertex.begin(), vertex.end());
  }
  std::vector<std::size_t> triangle_tags(surface.triangles.size());
  std::iota(triangle_tags.begin(), triangle_tags.end(), std::size_t{1});
  std::vector<std::size_t> corners;
  for (const Triangle& triangle : surface.triangles) {
    std::ranges::transform(triangle, std::back_inserter(corners),
                           [](int vertex) { return static_cast<std::size_t>(vertex) + 1; });
  }
  const int entity = gmsh::model::addDiscreteEntity(2);
  gmsh::model::mesh::addNodes(2, entity, node_tags, coordinates);
  gmsh::model::mesh::addElementsByType(entity, triangle_type, triangle_tags, corners);
}

/// The section in the plane y = 0, its coordinates in millimetres; returns the surface's tag.
int add_steel_section(const SteelSection& section) {
  namespace occ = gmsh::model::occ;
  const auto add_point = [](const Eigen::Vector2d& p) {
    return occ::addPoint(p.x() * millimetres_per_metre, 0.0, p.y() * millimetres_per_metre);
  };
  std::vector<int> points;
  std::ranges::transform(section.surface, std::back_inserter(points), add_point);
  std::vector<int> curves;
  for (std::size_t i = 1; i < points.size(); ++i) {
    curves.push_back(occ::addLine(points[i - 1], points[i]));
  }
  const int last_on_shell = add_point(section.surface.back().normalized() * section.shell_radius);
  const int first_on_shell = add_point(section.surface.front().normalized() * section.shell_radius);
  curves.push_back(occ::addLine(points.back(), last_on_shell));
  const int axis = add_point(Eigen::Vector2d::Zero());
  curves.push_back(occ::addCircleArc(last_on_shell, axis, first_on_shell));
  occ::remove({{0, axis}});
  curves.push_back(occ::addLine(first_on_shell, points.front()));
  return occ::addPlaneSurface({occ::addCurveLoop(curves)});
}

}  // namespace

Triangulation swept_polygon(const std::vector<Eigen::Vector2d>& corners, double length,
                            int layers) {
  return with_gmsh("mesh the liner", [&] {
    add_swept_sides(corners, length, layers);
    gmsh::model::mesh::generate(2);
    return read_mesh(static_cast<int>(corners.size()));
  });
}

void write_ascii_stl(const Triangulation& surface, const std::filesystem::path& path) {
  with_gmsh("write the STL file", [&] {
    add_discrete_surface(surface);
    gmsh::write(path.string());
    return true;
  });
}

void write_solid_step(const SteelSection& section, double length,
                      const std::filesystem::path& path) {
  with_gmsh("write the STEP file", [&] {
    namespace occ = gmsh::model::occ;
    gmsh::vectorpair swept;
    occ::extrude({{2, add_steel_section(section)}}, 0.0, length * millimetres_per_metre, 0.0,
                 swept);
    std::erase_if(swept, [](const auto& entity) { return entity.first != 3; });
    if (swept.size() != 1) {
      throw std::string("the section does not sweep one solid");
    }
    occ::synchronize();
    gmsh::write(path.string());
    return true;
  });
}

double volume_of_step(const std::filesystem::path& path) {
  return with_gmsh("read the STEP file", [&] {
    gmsh::vectorpair solids;
    gmsh::model::occ::importShapes(path.string(), solids);
    double volume = 0.0;
    for (const auto& [dimension, tag] : solids) {
      double mass = 0.0;
      gmsh::model::occ::getMass(dimension, tag, mass);
      volume += dimension == 3 ? mass : 0.0;
    }
    return volume / std::pow(millimetres_per_metre, 3);
  });
}

}  // namespace millwear::meshgen
