#pragma once
#include "mill/case/case.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear {

/// A mill of two steels, 1 m over the plate, for tests that set their own numbers.
inline Case example_case() {
  const LinerSector sector{0.52, 0.5, 12};
  return {.name = "example",
          .file = "example.toml",
          .slice_length = 0.2,
          .speed = 3.0,
          .feed_rate = {},
          .liner = profile_of(sector, {0.04, 0.05, 0.3, 0.2}),
          .materials = {{"steel", 7800.0, 7.752e10, 0.29}, {"ore", 2700.0, 7.55e9, 0.2}},
          .pairs = {{0, 0, 0.3, 0.001, 0.3}, {0, 1, 0.5, 0.002, 0.5}, {1, 1, 0.8, 0.005, 0.5}},
          .liner_material = 0,
          .charge = {{{0, 0.05, 100}, {1, 0.03, 1000}, {1, 0.02, 3000}}, {0.2, 0.1}, 0.4, 0.0},
          .dem = {.modulus_reduction = 100.0,
                  .rayleigh_fraction = 0.3,
                  .longest_time_step = {},
                  .rolling_friction = RollingFriction::cdt,
                  .mix_revolutions = 2.0,
                  .settle_pitches = 2,
                  .measure_revolutions = 1.0,
                  .contact_path = ContactPath::dumps,
                  .sample_every_steps = 20,
                  .ranks = 0,
                  .skin = {},
                  .mesh_tolerance = 0.03,
                  .seed = 1,
                  .keep_dumps = false,
                  .keep_events = false,
                  .pair_revolutions = 0.0},
          .wear = {{{WearLaw::archard, 1e-12}}, 120, 10, 0.1},
          .campaign = {0.15, 5, 0.01, 0.002, 50}};
}

}  // namespace millwear
