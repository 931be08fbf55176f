#include "liggghts_inputs/decks/charge_packing.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "liggghts_inputs/decks/free_space.h"
#include "liggghts_inputs/decks/random_draw.h"
#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

// Denser takes many more tries: 0.36 twice those of 0.34, 0.40 fifteen times.
constexpr double loose_solid_fraction = 0.34;
// The surface of a charge in motion, from shoulder to toe, leans by about this angle.
constexpr double lean = 40.0 * std::numbers::pi / 180.0;
constexpr int tries_per_particle = 20000;

/// A place in the mill's square under a level `top` [m] above the axis that leans as a charge does
/// that is carried up, with the highest part on the rising side.
Eigen::Vector3d place_under(double top, double radius, double slice_length,
                            std::mt19937_64& random) {
  const double across = radius * (2.0 * uniform_draw(random) - 1.0);
  const double along_axis = slice_length * uniform_draw(random);
  const double up = -radius + (radius + top) * uniform_draw(random);
  return {across * std::cos(lean) + up * std::sin(lean), along_axis,
          up * std::cos(lean) - across * std::sin(lean)};
}

}  // namespace

std::vector<PlacedParticle> pack_charge(const Case& mill) {
  const double plate = mill.liner.sector.plate_radius;
  const double solid = totals(mill).solid_volume;
  const double loose_top =
      level_for_area(plate, solid / (loose_solid_fraction * mill.slice_length));

  std::mt19937_64 random(mill.dem.seed);
  FreeSpace space(mill);
  std::vector<PlacedParticle> placed;
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c) {
    const auto& kind = mill.charge.classes[c];
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
        if (!space.is_free(centre, c)) continue;
        space.take(centre, c);
        placed.push_back({centre, c});
        break;
      }
    }
  }
  return placed;
}

}  // namespace millwear::liggghts
