#include "recorder/neighbours/size_grids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace millwear::recorder {
namespace {

constexpr double most_cells_a_sphere = 16.0;

/// The cell that `place` lies in, along one axis; outside the grid: the last or first one.
int cell_at(double place, double origin, double cell, int cells) {
  return static_cast<int>(std::clamp((place - origin) / cell, 0.0, cells - 1.0));
}

}  // namespace

SizeGrids::SizeGrids(const Spheres& spheres, const NeighbourReach& reach)
    : spheres_(spheres), reach_(reach) {
  if (spheres.radii.empty()) return;
  const double largest = std::ranges::max(spheres.radii);
  std::vector<std::vector<int>> octaves;
  for (std::size_t i = 0; i < spheres.radii.size(); ++i) {
    const auto octave = static_cast<std::size_t>(std::ilogb(largest / spheres.radii[i]));
    if (octave >= octaves.size()) octaves.resize(octave + 1);
    octaves[octave].push_back(static_cast<int>(i));
  }
  for (const auto& members : octaves)
    if (!members.empty()) grids_.push_back(grid_of(members));
}

SizeGrids::Grid SizeGrids::grid_of(const std::vector<int>& members) const {
  Grid grid{};
  Place low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const int i : members) {
    grid.largest_radius = std::max(grid.largest_radius, spheres_.radii[i]);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], spheres_.centres[i][axis]);
      high[axis] = std::max(high[axis], spheres_.centres[i][axis]);
    }
  }

  const auto count_cells = [&] {
    double all = 1.0;
    for (int axis = 0; axis < 3; ++axis)
      all *= std::floor((high[axis] - low[axis]) / grid.cell) + 1.0;
    return all;
  };
  grid.cell = 2.0 * grid.largest_radius * reach_.stretch + reach_.skin;
  const double most = most_cells_a_sphere * static_cast<double>(members.size());
  while (count_cells() > most) grid.cell *= 1.25;
  for (int axis = 0; axis < 3; ++axis) {
    grid.origin[axis] = low[axis];
    grid.cells[axis] = static_cast<int>((high[axis] - low[axis]) / grid.cell) + 1;
  }

  std::vector<int> cell_of(members.size());
  grid.first.assign(std::size_t{1} + grid.cells[0] * grid.cells[1] * grid.cells[2], 0);
  for (std::size_t m = 0; m < members.size(); ++m) {
    std::array<int, 3> at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = cell_at(spheres_.centres[members[m]][axis], grid.origin[axis], grid.cell,
                         grid.cells[axis]);
    cell_of[m] = (at[2] * grid.cells[1] + at[1]) * grid.cells[0] + at[0];
    ++grid.first[cell_of[m] + 1];
  }
  std::partial_sum(grid.first.begin(), grid.first.end(), grid.first.begin());
  auto next = grid.first;
  grid.entries.resize(members.size());
  for (std::size_t m = 0; m < members.size(); ++m) {
    const int i = members[m];
    const double* const x = spheres_.centres[i];
    grid.entries[next[cell_of[m]]++] = {x[0], x[1], x[2], spheres_.radii[i], i};
  }
  return grid;
}

template <class Take>
void SizeGrids::for_each_row(const Grid& grid, const Place& low, const Place& high,
                             const Place& far, Take take) {
  std::array<int, 3> from, to;
  for (int axis = 0; axis < 3; ++axis) {
    const double begin = low[axis] - far[axis];
    const double end = high[axis] + far[axis];
    const double grid_end = grid.origin[axis] + grid.cells[axis] * grid.cell;
    if (end < begin || end < grid.origin[axis] || begin > grid_end) return;
    from[axis] = cell_at(begin, grid.origin[axis], grid.cell, grid.cells[axis]);
    to[axis] = cell_at(end, grid.origin[axis], grid.cell, grid.cells[axis]);
  }
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j) {
      const int row = (k * grid.cells[1] + j) * grid.cells[0];
      const int begin = grid.first[row + from[0]];
      const int end = grid.first[row + to[0] + 1];
      take(std::span(grid.entries).subspan(begin, end - begin));
    }
}

void SizeGrids::add_later_neighbours(int sphere, std::vector<int>& neighbours) const {
  const double* const centre = spheres_.centres[sphere];
  const Place x = {centre[0], centre[1], centre[2]};
  const double radius = spheres_.radii[sphere];
  std::size_t count = neighbours.size();
  for (const auto& grid : grids_) {
    const double far = (radius + grid.largest_radius) * reach_.stretch + reach_.skin;
    for_each_row(grid, x, x, {far, far, far}, [&](std::span<const Entry> row) {
      if (neighbours.size() < count + row.size()) neighbours.resize(2 * (count + row.size()));
      // Written first and counted if near: which one is near no processor foresees.
      for (const auto& other : row) {
        const double dx = x[0] - other.x, dy = x[1] - other.y, dz = x[2] - other.z;
        const double near = (radius + other.radius) * reach_.stretch + reach_.skin;
        neighbours[count] = other.number;
        count += static_cast<std::size_t>(other.number > sphere) &
                 static_cast<std::size_t>(dx * dx + dy * dy + dz * dz <= near * near);
      }
    });
  }
  neighbours.resize(count);
}

void SizeGrids::add_spheres_near(const Place& low, const Place& high, const Place& growth,
                                 std::vector<int>& spheres) const {
  for (const auto& grid : grids_) {
    const double reach = grid.largest_radius * reach_.stretch + reach_.skin;
    for_each_row(grid, low, high, {growth[0] * reach, growth[1] * reach, growth[2] * reach},
                 [&](std::span<const Entry> row) {
                   for (const auto& entry : row) spheres.push_back(entry.number);
                 });
  }
}

}  // namespace millwear::recorder
