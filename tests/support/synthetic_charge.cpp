#include "tests/support/synthetic_charge.h"

#include <array>
#include <cmath>
#include <limits>

namespace millwear::orchestrator {

ChargeOfCycle synthetic_charge(int cycle, double age, const LinerProfile& liner) {
  constexpr double speed = 1.2;
  const double radius = liner.sector.plate_radius;
  const Eigen::Vector2d centre(-0.45 * radius, -0.35 * radius);
  const wear::SectionGrid grid{1.05 * radius, 48};
  const auto empty = [&] {
    return Eigen::VectorXd::Constant(grid.count(), std::numeric_limits<double>::quiet_NaN());
  };
  std::vector<SectionMap> maps{{"occupied", "1", empty()},        {"velocity_x", "m/s", empty()},
                               {"velocity_z", "m/s", empty()},    {"temperature", "m2/s2", empty()},
                               {"normal_power", "W/m3", empty()}, {"shear_power", "W/m3", empty()},
                               {"mean_diameter", "m", empty()},   {"share_of_steel", "1", empty()},
                               {"share_of_ore", "1", empty()}};
  for (Eigen::Index cell = 0; cell < grid.count(); ++cell) {
    const double x =
        (static_cast<double>(cell % grid.cells) + 0.5) * grid.cell_size() - grid.half_width;
    const double z =
        (static_cast<double>(cell / grid.cells) + 0.5) * grid.cell_size() - grid.half_width;
    if (std::hypot(x, z) > 0.98 * radius || 0.75 * x + z > -0.1 * radius) continue;
    const double off = std::hypot(x - centre.x(), z - centre.y()) / radius;
    const double power = 4e3 * std::exp(-9.0 * off);
    const double steel = 0.3 + 0.4 * std::exp(-4.0 * off);
    const std::array values{0.6,
                            speed * (z - centre.y()),
                            -speed * (x - centre.x()),
                            0.02 + off * off,
                            power,
                            1.5 * power,
                            0.1 - 0.04 * off,
                            steel,
                            1.0 - steel};
    for (std::size_t m = 0; m < maps.size(); ++m) maps[m].values[cell] = values[m];
  }
  return {.cycle = cycle,
          .speed = speed,
          .liner = liner,
          .grid = grid,
          .maps = maps,
          .landmarks = {.shoulder = 0.7 - 0.25 * age,
                        .bulk_toe = 3.9 + 0.1 * age,
                        .head = {-0.2 * radius, 0.55 * radius},
                        .centre = centre},
          .frames = std::nullopt};
}

wear::PolarLoad synthetic_polar_load(int bins) {
  auto load = wear::no_polar_load(bins);
  for (int bin = 0; bin < bins; ++bin)
    for (Eigen::Index column = 0; column < wear::polar_columns; ++column) {
      const double angle = 5.0 * (static_cast<double>(column) + 0.5) - 180.0;
      const double corner = std::exp(-std::pow(((bin + 0.5) / bins - 0.6) / 0.08, 2));
      const double slid = std::exp(-std::pow((angle - 40.0) / 50.0, 2));
      const double hit = std::exp(-std::pow((angle + 45.0) / 20.0, 2));
      load.values[0](bin, column) = 5e4 * (0.2 + corner) * slid;
      load.values[1](bin, column) = 3.0 * (0.1 + corner) * (0.2 * slid + hit);
      load.values[2](bin, column) = 9.0 * (0.2 + corner) * (slid + 0.3 * hit);
    }
  return load;
}

}  // namespace millwear::orchestrator
