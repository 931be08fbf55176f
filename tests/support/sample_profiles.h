#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// A mill of 2 m inside its new plate with ten rows: a pitch is 36 degrees, 0.628 m of plate.
inline const LinerSector sample_sector{1.05, 1.0, 10};

/// The plate alone, a circle of `radius` cut into `facets`.
inline LinerProfile bare_ring(double radius = 1.0, int facets = 40) {
  LinerProfile ring{sample_sector, {}};
  const double pitch = sample_sector.pitch();
  for (int i = 0; i <= facets; ++i) {
    ring.nodes.push_back(point_at(sample_sector, radius, pitch * (i - 0.5 * facets) / facets));
  }
  return ring;
}

/// An upright square lifter, 0.1 m wide and high, on a plate of straight lines: 90 degree corners
/// at (-0.05, 0.1) and (0.05, 0.1), feet at (-0.05, 0) and (0.05, 0), flat plate to +-0.2, from
/// there straight to the sector edges on the plate's circle.
inline LinerProfile square_lifter() {
  const double half = 0.5 * sample_sector.pitch();
  return {sample_sector,
          {point_at(sample_sector, 1.0, -half),
           {-0.2, 0.0},
           {-0.05, 0.0},
           {-0.05, 0.1},
           {0.05, 0.1},
           {0.05, 0.0},
           {0.2, 0.0},
           point_at(sample_sector, 1.0, half)}};
}

}  // namespace millwear::wear
