#include "liggghts_inputs/decks/charge_packing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <unordered_map>

#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "mill/liner/profile_measures.h"

namespace millwear::liggghts {
namespace {

// Denser takes many more tries: 0.36 twice those of 0.34, 0.40 fifteen times.
constexpr double loose_solid_fraction = 0.34;
// The surface of a charge in motion, from shoulder to toe, leans by about this angle.
constexpr double lean = 40.0 * std::numbers::pi / 180.0;
constexpr int tries_per_particle = 20000;
constexpr double clearance = 1e-6;
constexpr double box_margin = 1.02;

/// Particles of one class by cells of their own diameter, periodic along y.
class ClassGrid {
 public:
  ClassGrid(double diameter, double slice_length)
      : diameter_(diameter),
        slice_(slice_length),
        cells_y_(std::max(1L, static_cast<long>(slice_length / diameter))) {}

  void insert(const Eigen::Vector3d& centre) {
    cells_[key(cell(centre.x()), cell_y(centre.y()), cell(centre.z()))].push_back(centre);
  }

  [[nodiscard]] bool touches(const Eigen::Vector3d& centre, double diameter) const {
    const double reach = 0.5 * (diameter + diameter_) + clearance;
    const long span_y = std::min(
        cells_y_ / 2, static_cast<long>(reach * static_cast<double>(cells_y_) / slice_) + 1);
    for (long i = cell(centre.x() - reach); i <= cell(centre.x() + reach); ++i)
      for (long k = cell(centre.z() - reach); k <= cell(centre.z() + reach); ++k)
        for (long j = -span_y; j <= span_y; ++j)
          if (cell_touches(key(i, wrapped(cell_y(centre.y()) + j), k), centre, reach)) return true;
    return false;
  }

 private:
  [[nodiscard]] long cell(double x) const { return static_cast<long>(std::floor(x / diameter_)); }
  [[nodiscard]] long cell_y(double y) const {
    return wrapped(static_cast<long>(std::floor(y / slice_ * static_cast<double>(cells_y_))));
  }
  [[nodiscard]] long wrapped(long j) const { return ((j % cells_y_) + cells_y_) % cells_y_; }
  [[nodiscard]] static std::uint64_t key(long i, long j, long k) {
    constexpr std::uint64_t mask = (1U << 21) - 1;
    return (static_cast<std::uint64_t>(i) & mask) << 42 |
           (static_cast<std::uint64_t>(j) & mask) << 21 | (static_cast<std::uint64_t>(k) & mask);
  }
  [[nodiscard]] bool cell_touches(std::uint64_t cell_key, const Eigen::Vector3d& centre,
                                  double reach) const {
    const auto found = cells_.find(cell_key);
    if (found == cells_.end()) return false;
    return std::ranges::any_of(found->second, [&](const Eigen::Vector3d& other) {
      Eigen::Vector3d apart = other - centre;
      apart.y() -= slice_ * std::round(apart.y() / slice_);
      return apart.squaredNorm() < reach * reach;
    });
  }

  double diameter_;
  double slice_;
  long cells_y_;
  std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> cells_;
};

bool clear_of_liner(const LinerProfile& liner, double crest, double x, double z, double radius) {
  const double from_axis = std::hypot(x, z);
  const double reach = radius + clearance;
  if (from_axis + reach < crest) return true;
  if (from_axis + reach > liner.sector.plate_radius) return false;
  const Eigen::Vector2d point = to_master(liner.sector, x, z, 0.0).position;
  for (int pitch = -1; pitch <= 1; ++pitch)
    for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i) {
      const Eigen::Vector2d a = shifted_by_pitches(liner.sector, liner.nodes[i], pitch);
      const Eigen::Vector2d along = shifted_by_pitches(liner.sector, liner.nodes[i + 1], pitch) - a;
      const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if ((a + t * along - point).squaredNorm() < reach * reach) return false;
    }
  // Beyond the surface there is only steel: a free centre sees the profile from the mill's inside.
  const Eigen::Vector2d axis(0.0, liner.sector.plate_radius);
  for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i) {
    const Eigen::Vector2d d = liner.nodes[i + 1] - liner.nodes[i];
    const Eigen::Vector2d e = point - axis;
    const double cross = e.x() * d.y() - e.y() * d.x();
    if (cross == 0.0) continue;
    const Eigen::Vector2d f = liner.nodes[i] - axis;
    const double along_ray = (f.x() * d.y() - f.y() * d.x()) / cross;
    const double along_edge = (f.x() * e.y() - f.y() * e.x()) / cross;
    if (along_ray > 0.0 && along_ray < 1.0 && along_edge >= 0.0 && along_edge <= 1.0) return false;
  }
  return true;
}

/// Height z under which the circle's section holds `area`.
double level_for_area(double radius, double area) {
  double low = -radius;
  double high = radius;
  while (high - low > 1e-6 * radius) {
    const double z = 0.5 * (low + high);
    const double half = std::acos(std::clamp(-z / radius, -1.0, 1.0));
    const double below = radius * radius * (half - 0.5 * std::sin(2.0 * half));
    (below < area ? low : high) = z;
  }
  return high;
}

/// Half of the particles of the moving charge are beyond it, x [m]: the centroid of the circle's
/// section that the charge fills, turned up by an angle with a sine of 0.70 at 5 % filling and of
/// 0.80 at 40 %, as the 8 m mill's charge has it, with new lifters and with worn ones.
double middle_of_moving_charge(const Case& mill) {
  const double plate = mill.liner.sector.plate_radius;
  const double filling = computed_filling(mill);
  const double area = filling * std::numbers::pi * plate * plate;
  const double level = level_for_area(plate, area);
  const double centroid = 2.0 / 3.0 * std::pow(plate * plate - level * level, 1.5) / area;
  return -(0.69 + 0.28 * filling) * centroid;
}

/// A draw in [0, 1) that is the same on every platform.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// A place in the mill's square under a level `top` [m] above the axis that leans as a charge does
/// that is carried up, with the highest part on the rising side.
Eigen::Vector3d place_under(double top, double radius, double slice_length,
                            std::mt19937_64& random) {
  const double across = radius * (2.0 * uniform(random) - 1.0);
  const double along_axis = slice_length * uniform(random);
  const double up = -radius + (radius + top) * uniform(random);
  return {across * std::cos(lean) + up * std::sin(lean), along_axis,
          up * std::cos(lean) - across * std::sin(lean)};
}

}  // namespace

std::vector<PlacedParticle> pack_charge(const Case& mill) {
  const auto& liner = mill.liner;
  const double crest = crest_radius(liner);
  const double plate = liner.sector.plate_radius;
  const double solid = totals(mill).solid_volume;
  const double loose_top =
      level_for_area(plate, solid / (loose_solid_fraction * mill.slice_length));

  std::mt19937_64 random(mill.dem.seed);
  std::vector<ClassGrid> grids;
  std::vector<PlacedParticle> placed;
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c) {
    const auto& kind = mill.charge.classes[c];
    grids.emplace_back(kind.diameter, mill.slice_length);
    for (std::size_t n = 0; n < kind.count; ++n) {
      int tries = 0;
      while (true) {
        // Half-way through the tries the whole mill is opened to a particle that found no place.
        const double top = tries < tries_per_particle / 2 ? loose_top : plate;
        const Eigen::Vector3d centre = place_under(top, plate, mill.slice_length, random);
        if (++tries > tries_per_particle)
          throw InputError(fmt::format(
              "{}: the charge does not fit: {} of {} particles of {} m find no place ({:.1f} % of "
              "the mill's inside would be solid); lower the filling or the counts",
              mill.file.string(), kind.count - n, kind.count, kind.diameter,
              100.0 * solid / inside_volume(mill)));
        if (!clear_of_liner(liner, crest, centre.x(), centre.z(), 0.5 * kind.diameter)) continue;
        if (std::ranges::any_of(
                grids, [&](const ClassGrid& grid) { return grid.touches(centre, kind.diameter); }))
          continue;
        grids.back().insert(centre);
        placed.push_back({centre, c});
        break;
      }
    }
  }
  return placed;
}

std::string charge_data_file(const Case& mill, const std::vector<PlacedParticle>& charge) {
  const double half = box_margin * mill.liner.sector.shell_radius;
  const double middle = middle_of_moving_charge(mill);
  std::string text = fmt::format(
      "# charge of {}\n\n{} atoms\n{} atom types\n{} {} xlo xhi\n0 {} ylo yhi\n{} {} zlo zhi\n\n"
      "Atoms\n\n",
      mill.name, charge.size(), mill.materials.size(), 2.0 * middle - half, half, mill.slice_length,
      -half, half);
  std::size_t id = 0;
  for (const auto& particle : charge) {
    const auto& kind = mill.charge.classes[particle.particle_class];
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {}\n", ++id, kind.material + 1,
                   kind.diameter, mill.materials[kind.material].density, particle.centre.x(),
                   particle.centre.y(), particle.centre.z());
  }
  return text;
}

}  // namespace millwear::liggghts
