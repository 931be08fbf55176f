#include "tests/needs_liggghts/sphere_trial.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <stdexcept>

#include "liggghts_inputs/decks/charge_packing.h"
#include "liggghts_inputs/decks/deck.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear::trial {
namespace {

Case one_sphere(const LinerProfile& liner, double speed, double restitution) {
  return {.name = "sphere",
          .file = "sphere.toml",
          .slice_length = 0.1,
          .speed = speed,
          .feed_rate = {},
          .liner = liner,
          .materials = {{"steel", 7800.0, 7.752e10, 0.29}},
          .pairs = {{0, 0, 0.3, 0.001, restitution}},
          .liner_material = 0,
          .charge = {{{0, 2.0 * sphere_radius, 1}}, {{}, {}}, 0.4, 0.0},
          .dem = {.modulus_reduction = 100.0,
                  .rayleigh_fraction = 0.3,
                  .longest_time_step = {},
                  .rolling_friction = RollingFriction::cdt,
                  .mix_revolutions = 1.0,
                  .settle_pitches = 0,
                  .measure_revolutions = 1.0,
                  .contact_path = ContactPath::dumps,
                  .sample_every_steps = 1,
                  .ranks = 1,
                  .skin = {},
                  .mesh_tolerance = 1e-5 / sphere_radius,
                  .seed = 1,
                  .keep_dumps = false,
                  .keep_events = false,
                  .pair_revolutions = 0.0},
          .wear = {{{WearLaw::archard, 1e-12}}, 100, 4, 0.1},
          .campaign = {0.15, 5, 0.01, 0.002, 50}};
}

std::string with(std::string text, const std::string& old, const std::string& replacement) {
  const auto place = text.find(old);
  if (place == std::string::npos) throw std::logic_error("the deck holds no \"" + old + "\"");
  return text.replace(place, old.size(), replacement);
}

}  // namespace

Case square_mill(double restitution) {
  const LinerSector sector{0.32, -floor_level * std::numbers::sqrt2, 4};
  const double corner = 0.5 * sector.pitch();
  return one_sphere({sector,
                     {point_at(sector, sector.plate_radius, -corner),
                      {0.0, sector.plate_radius + floor_level},
                      point_at(sector, sector.plate_radius, corner)}},
                    1e-12, restitution);
}

Case round_mill() {
  const LinerSector sector{0.22, 0.2, 12};
  constexpr int facets = 12;
  LinerProfile ring{sector, {}};
  for (int i = 0; i <= facets; ++i)
    ring.nodes.push_back(
        point_at(sector, sector.plate_radius, sector.pitch() * (i - 0.5 * facets) / facets));
  Case mill = one_sphere(ring, 3.0, 0.9);
  mill.pairs.front().sliding_friction = 0.05;
  return mill;
}

double resting_overlap(const Case& mill) {
  const auto& steel = mill.materials.front();
  const double youngs = 2.0 * softened_shear_modulus(mill, 0) * (1.0 + steel.poisson_ratio);
  const double effective = youngs / (2.0 * (1.0 - steel.poisson_ratio * steel.poisson_ratio));
  return std::pow(0.75 * sphere_mass * gravity / (effective * std::sqrt(sphere_radius)), 2.0 / 3.0);
}

Launch resting(const Case& mill, const Eigen::Vector3d& place, const Eigen::Vector3d& velocity) {
  return {{place.x(), place.y(), floor_level + sphere_radius - resting_overlap(mill)},
          velocity,
          Eigen::Vector3d::Zero()};
}

namespace {

/// The data file with a box that is as wide on either side of the axis, and so is cut at x = 0.
std::string in_even_box(const std::string& data) {
  return std::regex_replace(data, std::regex("\\S+ (\\S+) xlo"), "-$1 $1 xlo");
}

liggghts::StretchExpectation write_sphere_deck(const Case& mill,
                                               const liggghts::StretchSteps& steps,
                                               const Launch& launch, const std::string& lines,
                                               const std::filesystem::path& folder, int ranks) {
  namespace names = liggghts::file_names;
  const auto mesh = write_liner_mesh(mill, mill.liner, folder);
  const std::string contact_model = fmt::format("include       {}\n", names::contact_model);
  const auto& v = launch.velocity;
  const auto& w = launch.spin;
  write_text(folder / names::charge,
             in_even_box(liggghts::charge_data_file(mill, {{launch.centre, 0}})) +
                 fmt::format("\nVelocities\n\n1 {} {} {} {} {} {}\n", v.x(), v.y(), v.z(), w.x(),
                             w.y(), w.z()));
  write_text(folder / names::contact_model,
             liggghts::contact_model_deck(mill, steps, {"liner.stl", mesh.triangles.size()},
                                          {liggghts::StretchKind::measure, 0}));
  write_text(folder / names::deck,
             with(with(liggghts::measuring_deck(mill, steps, mill.liner, names::charge, ranks),
                       "read_restart", "read_data"),
                  contact_model, contact_model + lines));
  return {1, mesh.triangles.size(), steps.total()};
}

}  // namespace

Dumps run_sphere(const Case& mill, const liggghts::StretchSteps& steps, const Launch& launch,
                 const std::string& lines) {
  const ScratchFolder scratch;
  const auto folder = scratch.stage("dem");
  return run_deck(folder, 1, write_sphere_deck(mill, steps, launch, lines, folder, 1));
}

Recording record_sphere(const Case& mill, const liggghts::StretchSteps& steps, const Launch& launch,
                        const std::string& lines, int ranks) {
  const ScratchFolder scratch;
  const auto folder = scratch.stage("dem");
  return record_deck(mill, steps, mill.liner, folder, ranks,
                     write_sphere_deck(mill, steps, launch, lines, folder, ranks));
}

}  // namespace millwear::trial
