#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mill/case/time_step.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

/// The same liner with lifters of `share` of their height over the plate.
LinerProfile lowered(LinerProfile liner, double share) {
  const auto& sector = liner.sector;
  for (auto& node : liner.nodes) {
    const double height = sector.plate_radius - radius_of(sector, node);
    if (height > 0.0)
      node = point_at(sector, sector.plate_radius - share * height, angle_of(sector, node));
  }
  return liner;
}

/// The deepest that any particle sinks into the wall in the first sample of a stretch [m].
double largest_overlap(const Case& mill, const Stretch& stretch) {
  const auto contacts = snapshots_of(stretch.dumps.contacts, liggghts::contact_columns).front();
  const auto spins = snapshots_of(stretch.dumps.spins, liggghts::spin_columns).front();
  double largest = 0.0;
  for (std::size_t i = 0; i < contacts.rows(); ++i)
    for (std::size_t j = 0; j < spins.rows(); ++j)
      if (spins.row(j)[0] == contacts.row(i)[4]) {
        Eigen::Vector3d arm = Eigen::Vector3d::Map(contacts.row(i).data()) -
                              Eigen::Vector3d::Map(spins.row(j).data() + 3);
        arm.y() -= mill.slice_length * std::round(arm.y() / mill.slice_length);
        largest = std::max(largest, spins.row(j)[2] - arm.norm());
      }
  return largest;
}

/// The largest distance from the axis of any contact, and the least [m].
std::pair<double, double> contact_radii(const Stretch& stretch) {
  std::pair<double, double> radii{0.0, 1e9};
  for (const auto& snapshot : snapshots_of(stretch.dumps.contacts, liggghts::contact_columns))
    for (std::size_t i = 0; i < snapshot.rows(); ++i) {
      const double radius = std::hypot(snapshot.row(i)[0], snapshot.row(i)[2]);
      radii = {std::max(radii.first, radius), std::min(radii.second, radius)};
    }
  return radii;
}

class WornMesh : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

// After whole pitches a liner whose lifters lost 8 of their 25 mm takes the place of the new one:
// the charge goes on as it was, and touches nothing where the new lifters stood.
TEST_F(WornMesh, TakesThePlaceOfTheNewOneAfterWholePitches) {
  const Case mill = small_mill(ContactPath::dumps);
  const auto plan = plan_steps(mill);
  const LinerProfile worn = lowered(mill.liner, 17.0 / 25.0);
  const ScratchFolder scratch;
  const StretchSteps mixing{plan.time_step, 3 * plan.steps_per_pitch, 0, 20};
  const StretchSteps at_once{plan.time_step, 1, 2 * plan.steps_per_pitch - 1, 20};
  const auto mixed = mix(mill, mixing, scratch.stage("mix"), 1);
  const auto as_new = measure(mill, at_once, mill.liner, scratch.stage("new"), "mix", 0, 1);
  const auto on_worn = measure(mill, at_once, worn, scratch.stage("worn"), "mix", 1, 1);

  const double kinetic = mixed.log.thermo.back().kinetic_energy;
  EXPECT_GT(kinetic, 0.1);
  for (const auto* stretch : {&as_new, &on_worn}) {
    EXPECT_NEAR(stretch->log.thermo.front().kinetic_energy, kinetic, 1e-3 * kinetic);
    for (const auto& line : stretch->log.thermo) EXPECT_EQ(line.atoms, 120u);
  }
  const double ball = smallest_diameter(mill);
  RecordProperty("overlap_new_um", std::to_string(1e6 * largest_overlap(mill, as_new)));
  RecordProperty("overlap_worn_um", std::to_string(1e6 * largest_overlap(mill, on_worn)));
  EXPECT_LT(largest_overlap(mill, as_new), 0.01 * ball);
  EXPECT_LT(largest_overlap(mill, on_worn), 0.01 * ball);

  const double plate = mill.liner.sector.plate_radius;
  RecordProperty("reach_new_mm", std::to_string(1e3 * (plate - contact_radii(as_new).second)));
  RecordProperty("reach_worn_mm", std::to_string(1e3 * (plate - contact_radii(on_worn).second)));
  EXPECT_GT(plate - contact_radii(as_new).second, 0.022);
  EXPECT_LT(plate - contact_radii(on_worn).second, 0.0185);
  EXPECT_NO_THROW(static_cast<void>(load_of(mill, at_once, worn, on_worn.dumps)));
  EXPECT_ANY_THROW(static_cast<void>(load_of(mill, at_once, mill.liner, on_worn.dumps)));
}

}  // namespace
}  // namespace millwear::trial
