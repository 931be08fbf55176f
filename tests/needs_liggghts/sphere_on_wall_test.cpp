#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/needs_liggghts/sphere_trial.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

class SphereOnWall : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

/// Vertical speed of the only sphere in a snapshot of spins [m/s].
double rise(const liggghts::Snapshot& spins) { return spins.row(0)[8]; }

class DroppedSphere : public SphereOnWall, public ::testing::WithParamInterface<double> {};

// A sphere that meets a plate with 1 m/s leaves it with e times that and has lost
// (1 - e^2) m v^2 / 2, which the load must show as normal dissipation. Gravity is left out, so that
// the speeds before and after are exact; some 1,400 steps cut the contact fine.
TEST_P(DroppedSphere, LosesOneMinusRestitutionSquaredOfItsEnergy) {
  const double e = GetParam();
  const Case mill = square_mill(e);
  const StretchSteps steps{5e-7, 0, 5000, 1};
  const double clearance = 1e-4;
  const Dumps dumps = run_sphere(mill, steps,
                                 {{0.05, 0.03, floor_level + sphere_radius + clearance},
                                  {0.0, 0.0, -1.0},
                                  Eigen::Vector3d::Zero()},
                                 "unfix gravity\n");
  const WallLoad load = load_of(mill, steps, mill.liner, dumps);
  const auto spins = snapshots_of(dumps.spins, liggghts::spin_columns);

  const auto contacts = snapshots_of(dumps.contacts, liggghts::contact_columns);
  const auto touching = [](const liggghts::Snapshot& snapshot) { return snapshot.rows() > 0; };
  const auto first = std::ranges::find_if(contacts, touching) - contacts.begin();
  const auto last =
      contacts.rend() - std::ranges::find_if(contacts.rbegin(), contacts.rend(), touching);
  const double fall = rise(spins.at(first - 1));
  const double rebound = rise(spins.at(last));
  const double lost = 0.5 * sphere_mass * (1.0 - e * e) * fall * fall;
  const double dissipated = load.total(Measure::normal_dissipation).sum();
  RecordProperty("rebound_share", fmt::format("{:.5f}", -rebound / fall / e));
  RecordProperty("dissipated_share", fmt::format("{:.5f}", dissipated / lost));
  const double really_lost = 0.5 * sphere_mass * (fall * fall - rebound * rebound);
  RecordProperty("dissipated_share_of_really_lost",
                 fmt::format("{:.5f}", dissipated / really_lost));
  RecordProperty("touching_steps", fmt::format("{}", last - first));
  EXPECT_NEAR(-rebound / fall, e, 0.01 * e);
  EXPECT_NEAR(dissipated, lost, 0.01 * lost);
  EXPECT_NEAR(dissipated, really_lost, 0.002 * really_lost);
  EXPECT_LT(load.total(Measure::sliding_work).sum(), 1e-6 * lost);
}

INSTANTIATE_TEST_SUITE_P(Restitution, DroppedSphere, ::testing::Values(0.3, 0.5, 0.8),
                         [](const auto& value) {
                           return "Tenths" + std::to_string(std::lround(10.0 * value.param));
                         });

// Archard: a sphere that cannot roll, pressed by its weight and dragged 0.2 m, takes k m g s.
TEST_F(SphereOnWall, DraggedWearsForceTimesDistance) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 20000, 10};
  for (const Eigen::Vector3d& velocity :
       {Eigen::Vector3d(0.5, 0.0, 0.0), Eigen::Vector3d(-0.3, 0.4, 0.0)}) {
    const Dumps dumps =
        run_sphere(mill, steps, resting(mill, -0.2 * velocity, velocity), drag_without_rolling);
    const WallLoad load = load_of(mill, steps, mill.liner, dumps);
    const double expected =
        mill.wear.mechanisms.front().specific_wear_rate * sphere_mass * gravity * 0.2;
    RecordProperty("worn_share", fmt::format("{:.5f}", worn_volume(mill, load) / expected));
    EXPECT_NEAR(worn_volume(mill, load), expected, 0.01 * expected);
  }
}

// The same with the wall drawn under a sphere that is held: a mill turning at 3 rad/s. The facets
// make the sphere hop, so the wall's impulse is m g T plus the sphere's gain in upward momentum.
// Spun at 20 rad/s its surface follows the wall at 0.3 m/s and slips by half as much.
TEST_F(SphereOnWall, HeldOnATurningWallWearsForceTimesDistance) {
  const Case mill = round_mill();
  const StretchSteps steps{2e-5, 2000, 8000, 1};
  for (const double spin : {0.0, 20.0}) {
    const Launch launch{
        {0.0, 0.05, -0.2 + sphere_radius}, Eigen::Vector3d::Zero(), {0.0, spin, 0.0}};
    const Dumps dumps = run_sphere(mill, steps, launch, drag_without_rolling);
    const WallLoad load = load_of(mill, steps, mill.liner, dumps);
    const auto spins = snapshots_of(dumps.spins, liggghts::spin_columns);
    const double impulse =
        sphere_mass * (gravity * steps.measure_time() + rise(spins.back()) - rise(spins.front()));
    const double slip = mill.speed * 0.2 - spin * sphere_radius;
    const double expected = mill.wear.mechanisms.front().specific_wear_rate * impulse * slip;
    RecordProperty(fmt::format("worn_share_at_{}_rad_per_s", spin),
                   fmt::format("{:.5f}", worn_volume(mill, load) / expected));
    EXPECT_NEAR(worn_volume(mill, load), expected, 0.01 * expected) << spin << " rad/s";
  }
}

// A sphere that rolls 0.2 m without slip wears nothing. Were its spin left out, its surface would
// seem to slide all the way.
TEST_F(SphereOnWall, RolledWearsNothing) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 20000, 10};
  const Eigen::Vector3d velocity(0.3, 0.4, 0.0);
  Launch launch = resting(mill, -0.2 * velocity, velocity);
  launch.spin = Eigen::Vector3d::UnitZ().cross(velocity) / sphere_radius;
  const Dumps dumps = run_sphere(mill, steps, launch);
  const double slid = mill.wear.mechanisms.front().specific_wear_rate * sphere_mass * gravity * 0.2;
  const double worn = worn_volume(mill, load_of(mill, steps, mill.liner, dumps));
  RecordProperty("worn_share", fmt::format("{:.6f}", worn / slid));
  EXPECT_LT(worn, 1e-3 * slid);
}

}  // namespace
}  // namespace millwear::trial
