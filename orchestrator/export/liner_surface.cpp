#include "orchestrator/export/liner_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mill/liner/mill_frame.h"

namespace millwear::orchestrator {
namespace {

/// Share of a bin up to which a node counts as its end.
constexpr double at_the_end = 1e-6;

double bin_width(const std::vector<double>& lengths, Eigen::Index bins) {
  return lengths.back() / static_cast<double>(bins);
}

VtkArray repeated(const VtkArray& array, int times) {
  VtkArray all = array;
  std::visit(
      [times](auto& numbers) {
        const auto once = numbers;
        for (int i = 1; i < times; ++i) numbers.insert(numbers.end(), once.begin(), once.end());
      },
      all.numbers);
  return all;
}

}  // namespace

LinerProfile cut_at_bins(const LinerProfile& profile, Eigen::Index bins) {
  const auto lengths = arc_lengths(profile);
  const double width = bin_width(lengths, bins);
  LinerProfile cut{profile.sector, {profile.nodes.front()}};
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    const double from = lengths[i - 1];
    const double length = lengths[i] - from;
    for (double end = std::floor(from / width + at_the_end) + 1.0;
         end * width < lengths[i] - at_the_end * width; end += 1.0)
      cut.nodes.push_back(profile.nodes[i - 1] + (end * width - from) / length *
                                                     (profile.nodes[i] - profile.nodes[i - 1]));
    cut.nodes.push_back(profile.nodes[i]);
  }
  return cut;
}

std::vector<Eigen::Index> bins_of_segments(const LinerProfile& outline, Eigen::Index bins) {
  const auto lengths = arc_lengths(outline);
  const double width = bin_width(lengths, bins);
  std::vector<Eigen::Index> found;
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    const double middle = 0.5 * (lengths[i - 1] + lengths[i]);
    found.push_back(std::min(static_cast<Eigen::Index>(middle / width), bins - 1));
  }
  return found;
}

VtkPolyData liner_surface(const LinerProfile& outline, const std::vector<VtkArray>& by_segment,
                          const LinerPlacement& placement) {
  const bool ring = placement.extent == LinerExtent::ring;
  const int rows = ring ? outline.sector.rows : 1;
  const int segments = static_cast<int>(outline.nodes.size()) - 1;
  VtkPolyData surface;
  const auto add_point = [&](const Eigen::Vector2d& node, int row) {
    const auto xz = to_mill(outline.sector, node, row, placement.mill_angle);
    for (const double y : {0.0, placement.slice_length})
      for (const double coordinate : {xz.x(), y, xz.y()})
        surface.points.push_back(static_cast<float>(coordinate));
  };
  // A lifter's last node is the first of the next one.
  for (int row = 0; row < rows; ++row)
    for (int node = 0; node < segments; ++node)
      add_point(outline.nodes[static_cast<std::size_t>(node)], row);
  if (!ring) add_point(outline.nodes.back(), 0);
  const int nodes = rows * segments + (ring ? 0 : 1);
  for (int first = 0; first < rows * segments; ++first) {
    const int next = (first + 1) % nodes;
    surface.polygons.add({2 * first, 2 * first + 1, 2 * next + 1, 2 * next});
  }
  for (const auto& array : by_segment) surface.cell_data.push_back(repeated(array, rows));
  return surface;
}

}  // namespace millwear::orchestrator
