#include "mill/case/case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"

namespace millwear {

const MaterialPair& pair_of(const Case& mill, std::size_t a, std::size_t b) {
  const auto found =
      std::find_if(mill.pairs.begin(), mill.pairs.end(), [a, b](const MaterialPair& pair) {
        return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
      });
  if (found == mill.pairs.end()) {
    const std::string& first = mill.materials.at(a).name;
    const std::string& second = mill.materials.at(b).name;
    throw InputError(fmt::format(
        "no friction is given between {0} and {1} (they touch in this mill); add a [[pairs]] with "
        "materials = [\"{0}\", \"{1}\"]",
        first, second));
  }
  return *found;
}

ChargeTotals totals(const Case& mill) {
  ChargeTotals sum{0, 0.0, 0.0};
  for (const ParticleClass& c : mill.charge.classes) {
    const double volume = static_cast<double>(c.count) * sphere_volume(c.diameter);
    sum.particles += c.count;
    sum.solid_volume += volume;
    sum.mass += volume * mill.materials.at(c.material).density;
  }
  return sum;
}

double inside_volume(const Case& mill) {
  const LinerSector& sector = mill.liner.sector;
  const double section = std::numbers::pi * sector.shell_radius * sector.shell_radius -
                         sector.rows * steel_area(mill.liner);
  return section * mill.slice_length;
}

double filling_inside_plate(const Case& mill) {
  const double radius = mill.liner.sector.plate_radius;
  const double inside = std::numbers::pi * radius * radius * mill.slice_length;
  return totals(mill).solid_volume / (1.0 - mill.charge.porosity) / inside;
}

double computed_filling(const Case& mill) {
  return totals(mill).solid_volume / (1.0 - mill.charge.porosity) / inside_volume(mill);
}

double critical_speed_fraction(const Case& mill) {
  return mill.speed / critical_speed(mill.liner.sector, largest_diameter(mill));
}

double critical_speed(const LinerSector& sector, double largest) {
  return std::sqrt(standard_gravity / (sector.plate_radius - 0.5 * largest));
}

double modulus_reduction(const Case& mill, std::size_t material) {
  return mill.materials.at(material).modulus_reduction.value_or(mill.dem.modulus_reduction);
}

double softened_shear_modulus(const Case& mill, std::size_t material) {
  return mill.materials.at(material).shear_modulus / modulus_reduction(mill, material);
}

double largest_diameter(const Case& mill) { return largest_diameter(mill.charge.classes); }

double smallest_diameter(const Case& mill) { return smallest_diameter(mill.charge.classes); }

std::string_view name_of(RollingFriction model) {
  return model == RollingFriction::cdt ? "cdt" : "epsd2";
}

std::string_view name_of(ContactPath path) {
  return path == ContactPath::recorder ? "recorder" : "dumps";
}

std::string_view name_of(RankSplit split) {
  switch (split) {
    case RankSplit::charge:
      return "charge";
    case RankSplit::axis:
      return "axis";
    case RankSplit::balanced:
      break;
  }
  return "balanced";
}

double mesh_tolerance(const Case& mill) {
  return mill.dem.mesh_tolerance * 0.5 * smallest_diameter(mill);
}

double particle_mass(const Case& mill, const ParticleClass& kind) {
  return mill.materials.at(kind.material).density * sphere_volume(kind.diameter);
}

std::string spoken_classes(const Case& mill) {
  std::string text;
  for (const ParticleClass& kind : mill.charge.classes) {
    text += fmt::format("{}{} of {:.4g} m", text.empty() ? "" : ", ",
                        mill.materials[kind.material].name, kind.diameter);
  }
  return text;
}

}  // namespace millwear
