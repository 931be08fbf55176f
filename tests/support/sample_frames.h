#pragma once
#include "wear/charge/charge_frames.h"

namespace millwear::wear {

/// Two frames of two particles, a large and a small one, 0.1 s apart. The large one rests at
/// (-0.25, 0.1, -0.25) and spins with (1, 2, 3); the small one flies with (1, 0, 2) from
/// (0.4, 0.1, -0.25) to (0.5, 0.1, -0.05).
inline ChargeFrames sample_frames() {
  ChargeFrames frames{.across = {-1.0, 1.0},
                      .along = {0.0, 0.2},
                      .speed = {0.0, 10.0},
                      .thinning = 2,
                      .times = {0.05, 0.15},
                      .mill_angles = {0.25, 0.5},
                      .class_radius = {0.025, 0.015, 0.01},
                      .classes = {0, 1},
                      .places = {},
                      .speeds = {},
                      .state = {-0.25F, 0.4F, 0.1F, 0.1F, -0.25F, -0.25F,  // x, y, z
                                0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F,        // velocity
                                1.0F, 0.0F, 2.0F, 0.0F, 3.0F, 0.0F}};      // spin
  const auto x_and_z = [&](double value) { return frames.across.packed(value); };
  const auto y = frames.along.packed(0.1);
  frames.places = {x_and_z(-0.25), x_and_z(0.4), y, y, x_and_z(-0.25), x_and_z(-0.25),
                   x_and_z(-0.25), x_and_z(0.5), y, y, x_and_z(-0.25), x_and_z(-0.05)};
  for (const double speed : {0.0, 2.236, 0.0, 2.0})
    frames.speeds.push_back(frames.speed.packed(speed));
  return frames;
}

}  // namespace millwear::wear
