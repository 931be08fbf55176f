#include "meshgen/profile_cad.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "meshgen/drawing/drawing_profile.h"
#include "meshgen/drawing/dxf_polyline.h"
#include "meshgen/gmsh_kernel.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/liner/mill_frame.h"
#include "mill/liner/profile_measures.h"

namespace millwear::meshgen {
namespace {

constexpr double volume_precision = 1e-6;  ///< share of the volume
constexpr double node_precision = 1e-9;    ///< [m]
constexpr const char* layer = "LINER";

/// Takes out what differs from one writing to the next: the time, and the number of the file among
/// those that the process has written.
void make_reproducible(const std::filesystem::path& path) {
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const std::regex time(R"('\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d')");
  const std::regex file_number(R"((Open CASCADE STEP translator \d+\.\d+) [\d.]+)");
  std::ofstream out(path, std::ios::trunc);
  out << std::regex_replace(std::regex_replace(text, time, "'1970-01-01T00:00:00'"), file_number,
                            "$1");
  out.close();
  if (!out) {
    throw DiskError(fmt::format("{}: cannot be written; is the disk full?", path.string()));
  }
}

}  // namespace

void write_step(const LinerProfile& profile, double slice_length,
                const std::filesystem::path& path) {
  SteelSection section{{}, profile.sector.shell_radius};
  for (const Eigen::Vector2d& node : profile.nodes) {
    section.surface.push_back(to_mill(profile.sector, node, 0, 0.0));
  }
  const double expected = steel_area(profile) * slice_length;
  publish_written(path, [&](const std::filesystem::path& beside) {
    write_solid_step(section, slice_length, beside);
    make_reproducible(beside);
    const double volume = volume_of_step(beside);
    if (!(std::abs(volume - expected) <= volume_precision * expected)) {
      throw ResultRejected(
          fmt::format("{}: its solid holds {:.9g} m3 where the profile has {:.9g} m3",
                      path.string(), volume, expected));
    }
  });
}

void write_dxf(const LinerProfile& profile, const std::filesystem::path& path) {
  publish_written(path, [&](const std::filesystem::path& beside) {
    write_dxf_polyline(profile.nodes, layer, beside);
    const double metres = name_of(LengthUnit::millimetre).metres;
    const auto nodes = drawing_profile(beside, layer).nodes;
    const bool same = std::ranges::equal(nodes, profile.nodes, [&](const auto& a, const auto& b) {
      return (metres * a - b).norm() <= node_precision;
    });
    if (!same) {
      throw ResultRejected(
          fmt::format("{}: its nodes do not read back as the profile's", path.string()));
    }
  });
}

}  // namespace millwear::meshgen
