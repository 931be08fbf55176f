#include "liggghts_inputs/decks/carried_charge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "liggghts_inputs/decks/free_space.h"
#include "liggghts_inputs/decks/nearest_place.h"
#include "liggghts_inputs/decks/random_draw.h"
#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

constexpr double share_of_diameter = 0.02;  // that a contact with the steel may be deep
constexpr double same_length = 1e-9;        // relative

std::size_t one_of(std::size_t count, std::mt19937_64& random) {
  return static_cast<std::size_t>(uniform_draw(random) * static_cast<double>(count));
}

bool is_same(double a, double b) { return std::abs(a - b) <= same_length * std::abs(b); }

bool has_same_classes(const Case& mill, const Case& source) {
  if (mill.charge.classes.size() != source.charge.classes.size()) return false;
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c) {
    const auto& here = mill.charge.classes[c];
    const auto& there = source.charge.classes[c];
    if (!is_same(here.diameter, there.diameter) ||
        mill.materials[here.material].name != source.materials[there.material].name)
      return false;
  }
  return true;
}

/// The particles of one class, in the order of the charge.
std::vector<std::vector<PlacedParticle>> by_class(const Case& mill,
                                                  std::vector<PlacedParticle> charge) {
  std::vector<std::vector<PlacedParticle>> classes(mill.charge.classes.size());
  for (auto& particle : charge) classes[particle.particle_class].push_back(std::move(particle));
  return classes;
}

void shift_along_axis(std::vector<PlacedParticle>& charge, double slice, double shift) {
  for (auto& particle : charge) {
    double& y = particle.centre.y();
    y += shift;
    y -= slice * std::floor(y / slice);
    if (y >= slice) y = 0.0;
  }
}

/// Takes as many out as there are too many. Returns how many that were.
std::size_t leave_surplus(std::vector<PlacedParticle>& particles, std::size_t wanted,
                          std::mt19937_64& random) {
  const std::size_t surplus = particles.size() > wanted ? particles.size() - wanted : 0;
  for (std::size_t i = 0; i < surplus; ++i)
    particles.erase(particles.begin() +
                    static_cast<std::ptrdiff_t>(one_of(particles.size(), random)));
  return surplus;
}

/// Twins of some particles, as many as are wanted and not there.
std::vector<PlacedParticle> twins(const std::vector<PlacedParticle>& particles, std::size_t wanted,
                                  std::mt19937_64& random) {
  std::vector<PlacedParticle> more;
  while (particles.size() + more.size() < wanted)
    more.push_back(particles[one_of(particles.size(), random)]);
  return more;
}

void check_not_empty(const Case& mill, const std::vector<PlacedParticle>& particles,
                     const ParticleClass& kind) {
  if (particles.empty() && kind.count > 0)
    throw InputError(fmt::format(
        "{}: the charge to begin with has no {} of {:g} mm; take `charge_from` out of [dem]",
        mill.file.string(), mill.materials[kind.material].name, 1e3 * kind.diameter));
}

}  // namespace

void check_same_charge(const Case& mill, const Case& source) {
  std::vector<std::string> problems;
  const auto compare = [&](const std::string& what, double here, double there, const char* unit) {
    if (!is_same(here, there))
      problems.push_back(fmt::format("{} ({:g} {}, there {:g})", what, here, unit, there));
  };
  compare("the shell's diameter", 2.0 * mill.liner.sector.shell_radius,
          2.0 * source.liner.sector.shell_radius, "m");
  compare("the slice's length", mill.slice_length, source.slice_length, "m");
  if (!has_same_classes(mill, source)) {
    problems.push_back(
        fmt::format("the charge ({}, there {})", spoken_classes(mill), spoken_classes(source)));
  } else {
    for (std::size_t c = 0; c < mill.charge.classes.size(); ++c) {
      const auto& material = mill.materials[mill.charge.classes[c].material];
      compare(fmt::format("the density of {}", material.name), material.density,
              source.materials[source.charge.classes[c].material].density, "kg/m3");
    }
  }
  if (!problems.empty())
    throw InputError(fmt::format(
        "{}: `charge_from` in [dem] names {}, whose charge is of another mill; it differs in {}; "
        "take the key out, or name a campaign of the same mill and charge",
        mill.file.string(), source.file.string(), fmt::join(problems, ", ")));
}

CarriedCharge carried_charge(const Case& mill, std::vector<PlacedParticle> source) {
  std::mt19937_64 random(mill.dem.seed);
  shift_along_axis(source, mill.slice_length, uniform_draw(random) * mill.slice_length);
  auto classes = by_class(mill, std::move(source));
  CarriedCharge carried;
  FreeSpace space(mill);
  std::vector<std::vector<PlacedParticle>> homeless(classes.size());
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const auto& kind = mill.charge.classes[c];
    check_not_empty(mill, classes[c], kind);
    carried.left += leave_surplus(classes[c], kind.count, random);
    homeless[c] = twins(classes[c], kind.count, random);
    carried.added += homeless[c].size();
    for (auto& particle : classes[c]) {
      if (space.is_clear_of_liner(particle.centre, c, share_of_diameter * kind.diameter)) {
        space.take(particle.centre, c);
        carried.particles.push_back(particle);
      } else {
        ++carried.moved;
        homeless[c].push_back(particle);
      }
    }
  }
  for (std::size_t c = 0; c < classes.size(); ++c) {
    NearestPlace nearest(space, mill, c);
    for (auto& particle : homeless[c]) {
      const auto place = nearest.find(particle.centre);
      if (!place)
        throw InputError(
            fmt::format("{}: the charge of `charge_from` in [dem] finds no room in this mill; "
                        "lower the filling",
                        mill.file.string()));
      particle.centre = *place;
      space.take(particle.centre, c);
      carried.particles.push_back(particle);
    }
  }
  return carried;
}

}  // namespace millwear::liggghts
