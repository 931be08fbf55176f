#include "liggghts_inputs/decks/charge_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace millwear::liggghts {
namespace {

constexpr double box_margin = 1.02;

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

std::string velocities(const std::vector<PlacedParticle>& charge) {
  std::string text = "\nVelocities\n\n";
  std::size_t id = 0;
  for (const auto& particle : charge)
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {}\n", ++id, particle.velocity.x(),
                   particle.velocity.y(), particle.velocity.z(), particle.spin.x(),
                   particle.spin.y(), particle.spin.z());
  return text;
}

}  // namespace

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
  const bool is_at_rest = std::ranges::all_of(charge, [](const PlacedParticle& particle) {
    return particle.velocity.isZero(0.0) && particle.spin.isZero(0.0);
  });
  return is_at_rest ? text : text + velocities(charge);
}

}  // namespace millwear::liggghts
