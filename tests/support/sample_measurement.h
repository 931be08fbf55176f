#pragma once
#include "mill/liner/mill_frame.h"
#include "mill/load/wall_contacts.h"
#include "tests/support/sample_profiles.h"
#include "wear/record/load_accumulator.h"

namespace millwear::wear {

/// Two classes of 1 and 2 kg, four blocks of half a second.
inline const LoadMeasurement sample_measurement{.bins = 50,
                                                .class_mass = {1.0, 2.0},
                                                .particles = 4000,
                                                .triangles = 3,
                                                .block_count = 4,
                                                .slice_length = 0.25,
                                                .duration = 2.0,
                                                .sample_interval = 0.01,
                                                .contact_limit = 1e-3,
                                                .excess_speed = 0.1};

/// Particle 7, of 2 kg, slides on the liner at a place of the master frame.
inline WallContact sample_contact(const Eigen::Vector2d& master, int row, double mill_angle) {
  const auto place = to_mill(sample_sector, master, row, mill_angle);
  return {.point = {place.x(), 0.1, place.y()},
          .into_wall = Eigen::Vector3d(place.x(), 0.0, place.y()).normalized(),
          .normal_force = 100.0,
          .slip_speed = 0.5,
          .path_speed = 0.75,
          .normal_speed = 0.2,
          .impact_speed = 0.4,
          .impact_normal_speed = 0.2,
          .shear_power = 15.0,
          .finnie_power = 3.0,
          .particle_class = 1,
          .particle = 7,
          .triangle = 2};
}

}  // namespace millwear::wear
