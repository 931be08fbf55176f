#pragma once
#include "mill/case/case.h"
#include "mill/load/load_measurement.h"

namespace millwear::orchestrator {

/// A second of the example mill in a hundred samples and ten blocks.
inline LoadMeasurement example_measurement(const Case& mill) {
  return {.bins = mill.wear.bins,
          .class_mass = {1.0, 0.1, 0.05},
          .particles = 10,
          .triangles = 1,
          .block_count = 10,
          .slice_length = mill.slice_length,
          .duration = 1.0,
          .sample_interval = 0.01,
          .contact_limit = 1e-3,
          .excess_speed = 0.1};
}

}  // namespace millwear::orchestrator
