#include "mill/load/load_measurement.h"

#include <utility>

#include "mill/case/case.h"

namespace millwear {

LoadMeasurement load_measurement(const Case& mill, double duration, double sample_interval,
                                 std::size_t triangles) {
  std::vector<double> class_mass;
  for (const auto& kind : mill.charge.classes) class_mass.push_back(particle_mass(mill, kind));
  return {.bins = mill.wear.bins,
          .class_mass = std::move(class_mass),
          .particles = totals(mill).particles,
          .triangles = triangles,
          .block_count = static_cast<std::size_t>(mill.wear.time_blocks),
          .slice_length = mill.slice_length,
          .duration = duration,
          .sample_interval = sample_interval,
          .contact_limit = 1.5 * mesh_tolerance(mill) + 0.02 * largest_diameter(mill),
          .excess_speed = mill.wear.excess_speed};
}

}  // namespace millwear
