#include "liggghts_inputs/decks/free_space.h"

#include <algorithm>
#include <cmath>

#include "mill/liner/mill_frame.h"
#include "mill/liner/profile_measures.h"

namespace millwear::liggghts {
namespace {

constexpr double clearance = 1e-6;

std::uint64_t key(long i, long j, long k) {
  constexpr std::uint64_t mask = (1U << 21) - 1;
  return (static_cast<std::uint64_t>(i) & mask) << 42 |
         (static_cast<std::uint64_t>(j) & mask) << 21 | (static_cast<std::uint64_t>(k) & mask);
}

/// Greatest distance of the profile from the mill's axis [m], at least that of the new plate.
double deepest_radius(const LinerProfile& liner) {
  double deepest = liner.sector.plate_radius;
  for (const auto& node : liner.nodes)
    deepest = std::max(deepest, std::hypot(node.x(), liner.sector.plate_radius - node.y()));
  return deepest;
}

bool is_near_surface(const LinerProfile& liner, const Eigen::Vector2d& point, double reach) {
  for (int pitch = -1; pitch <= 1; ++pitch)
    for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i) {
      const Eigen::Vector2d a = shifted_by_pitches(liner.sector, liner.nodes[i], pitch);
      const Eigen::Vector2d along = shifted_by_pitches(liner.sector, liner.nodes[i + 1], pitch) - a;
      const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if ((a + t * along - point).squaredNorm() < reach * reach) return true;
    }
  return false;
}

/// Beyond the surface there is only steel: a free centre sees the profile from the mill's inside.
bool is_in_steel(const LinerProfile& liner, const Eigen::Vector2d& point) {
  const Eigen::Vector2d axis(0.0, liner.sector.plate_radius);
  for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i) {
    const Eigen::Vector2d d = liner.nodes[i + 1] - liner.nodes[i];
    const Eigen::Vector2d e = point - axis;
    const double cross = e.x() * d.y() - e.y() * d.x();
    if (cross == 0.0) continue;
    const Eigen::Vector2d f = liner.nodes[i] - axis;
    const double along_ray = (f.x() * d.y() - f.y() * d.x()) / cross;
    const double along_edge = (f.x() * e.y() - f.y() * e.x()) / cross;
    if (along_ray > 0.0 && along_ray < 1.0 && along_edge >= 0.0 && along_edge <= 1.0) return true;
  }
  return false;
}

}  // namespace

FreeSpace::ClassGrid::ClassGrid(double diameter, double slice_length)
    : diameter_(diameter),
      slice_(slice_length),
      cells_y_(std::max(1L, static_cast<long>(slice_length / diameter))) {}

void FreeSpace::ClassGrid::insert(const Eigen::Vector3d& centre) {
  cells_[key(cell(centre.x()), cell_y(centre.y()), cell(centre.z()))].push_back(centre);
}

bool FreeSpace::ClassGrid::touches(const Eigen::Vector3d& centre, double diameter) const {
  const double reach = 0.5 * (diameter + diameter_) + clearance;
  const long span_y =
      std::min(cells_y_ / 2, static_cast<long>(reach * static_cast<double>(cells_y_) / slice_) + 1);
  for (long i = cell(centre.x() - reach); i <= cell(centre.x() + reach); ++i)
    for (long k = cell(centre.z() - reach); k <= cell(centre.z() + reach); ++k)
      for (long j = -span_y; j <= span_y; ++j)
        if (cell_touches(key(i, wrapped(cell_y(centre.y()) + j), k), centre, reach)) return true;
  return false;
}

long FreeSpace::ClassGrid::cell(double x) const {
  return static_cast<long>(std::floor(x / diameter_));
}

long FreeSpace::ClassGrid::cell_y(double y) const {
  return wrapped(static_cast<long>(std::floor(y / slice_ * static_cast<double>(cells_y_))));
}

bool FreeSpace::ClassGrid::cell_touches(std::uint64_t cell_key, const Eigen::Vector3d& centre,
                                        double reach) const {
  const auto found = cells_.find(cell_key);
  if (found == cells_.end()) return false;
  return std::ranges::any_of(found->second, [&](const Eigen::Vector3d& other) {
    Eigen::Vector3d apart = other - centre;
    apart.y() -= slice_ * std::round(apart.y() / slice_);
    return apart.squaredNorm() < reach * reach;
  });
}

FreeSpace::FreeSpace(const Case& mill)
    : liner_(mill.liner), crest_(crest_radius(liner_)), deepest_(deepest_radius(liner_)) {
  for (const auto& kind : mill.charge.classes) {
    diameters_.push_back(kind.diameter);
    grids_.emplace_back(kind.diameter, mill.slice_length);
  }
}

bool FreeSpace::is_clear_of_liner(const Eigen::Vector3d& centre, std::size_t particle_class,
                                  double overlap) const {
  const double reach = 0.5 * diameters_[particle_class] - overlap;
  const double from_axis = std::hypot(centre.x(), centre.z());
  if (from_axis + reach < crest_) return true;
  if (from_axis + reach > deepest_) return false;
  const Eigen::Vector2d point = to_master(liner_.sector, centre.x(), centre.z(), 0.0).position;
  return !is_near_surface(liner_, point, reach) && !is_in_steel(liner_, point);
}

bool FreeSpace::is_free(const Eigen::Vector3d& centre, std::size_t particle_class) const {
  if (!is_clear_of_liner(centre, particle_class, -clearance)) return false;
  return std::ranges::none_of(grids_, [&](const ClassGrid& grid) {
    return grid.touches(centre, diameters_[particle_class]);
  });
}

void FreeSpace::take(const Eigen::Vector3d& centre, std::size_t particle_class) {
  grids_[particle_class].insert(centre);
}

}  // namespace millwear::liggghts
