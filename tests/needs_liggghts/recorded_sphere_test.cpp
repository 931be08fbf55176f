#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/needs_liggghts/sphere_trial.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

class RecordedSphere : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

double sum(const Recording& recording, Measure measure) {
  return recording.record.load.total(measure).sum();
}

/// Velocity of the only sphere in the last dump [m/s].
Eigen::Vector3d last_velocity(const Recording& recording) {
  const auto spins = snapshots_of(recording.dumps.spins, liggghts::spin_columns);
  const auto row = spins.back().row(0);
  return {row[6], row[7], row[8]};
}
Eigen::Vector3d last_spin(const Recording& recording) {
  const auto spins = snapshots_of(recording.dumps.spins, liggghts::spin_columns);
  const auto row = spins.back().row(0);
  return {row[9], row[10], row[11]};
}

double energy(const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) {
  return 0.5 * sphere_mass * velocity.squaredNorm() +
         0.5 * 0.4 * sphere_mass * sphere_radius * sphere_radius * spin.squaredNorm();
}

/// A sphere on its way to the plate, without gravity.
Recording thrown(const Case& mill, const Eigen::Vector3d& velocity,
                 const Eigen::Vector3d& spin = Eigen::Vector3d::Zero()) {
  const StretchSteps steps{5e-7, 0, 5000, 1};
  const double clearance = 1e-4 * std::abs(velocity.z());
  return record_sphere(mill, steps,
                       {{0.02, 0.03, floor_level + sphere_radius + clearance}, velocity, spin},
                       "unfix gravity\n");
}

struct Throw {
  double restitution;
  double degrees;  ///< from the plate
};

class ThrownSphere : public RecordedSphere, public ::testing::WithParamInterface<Throw> {};

// Whatever the angle, what the collision took from the sphere's energy is what the record holds as
// normal and shear dissipation, but for the little that rolling friction took; the normal part is
// (1 - e^2) m v_n^2 / 2; and it was one collision of that speed and angle.
TEST_P(ThrownSphere, LosesWhatTheRecordHolds) {
  const auto [e, degrees] = GetParam();
  const double angle = degrees * std::numbers::pi / 180.0;
  const Case mill = square_mill(e);
  const Eigen::Vector3d velocity(std::cos(angle), 0.0, -std::sin(angle));
  const Recording recording = thrown(mill, velocity);
  const double normal = sum(recording, Measure::normal_dissipation);
  const double shear = sum(recording, Measure::shear_dissipation);
  const double lost = energy(velocity, Eigen::Vector3d::Zero()) -
                      energy(last_velocity(recording), last_spin(recording));
  const double normal_lost = 0.5 * sphere_mass * (1.0 - e * e) * velocity.z() * velocity.z();
  RecordProperty("normal_share", fmt::format("{:.5f}", normal / normal_lost));
  RecordProperty("total_share", fmt::format("{:.5f}", (normal + shear) / lost));
  EXPECT_NEAR(normal, normal_lost, 0.01 * normal_lost);
  EXPECT_NEAR(normal + shear, lost, 0.003 * lost);
  EXPECT_GE(shear, -1e-9 * lost);
  EXPECT_LT(energy(last_velocity(recording), last_spin(recording)),
            energy(velocity, Eigen::Vector3d::Zero()));

  ASSERT_EQ(recording.collisions.size(), 1u);
  const auto& collision = recording.collisions.front();
  EXPECT_EQ(sum(recording, Measure::events), 1.0);
  EXPECT_EQ(collision.unfinished, wear::Unfinished::none);
  EXPECT_NEAR(collision.impact_speed, 1.0, 1e-6);
  EXPECT_NEAR(collision.impact_angle, angle, 1e-5);
  EXPECT_NEAR(collision.normal_dissipation, normal, 1e-9 * normal);
  EXPECT_NEAR(sum(recording, Measure::incident_energy), 0.5 * sphere_mass, 1e-6 * sphere_mass);
  EXPECT_NEAR(sum(recording, Measure::excess_energy), 0.5 * sphere_mass * 0.9 * 0.9,
              1e-6 * sphere_mass);
}

INSTANTIATE_TEST_SUITE_P(Angles, ThrownSphere,
                         ::testing::Values(Throw{0.3, 90.0}, Throw{0.5, 90.0}, Throw{0.8, 90.0},
                                           Throw{0.3, 45.0}, Throw{0.8, 30.0}, Throw{0.5, 14.0},
                                           Throw{0.5, 76.0}),
                         [](const auto& value) {
                           return fmt::format("Tenths{:.0f}At{:.0f}Degrees",
                                              10.0 * value.param.restitution, value.param.degrees);
                         });

// Sliding all the way at a shallow angle, the tangential impulse is mu (1 + e) m v_n. Without
// damping: where damping pulls as a contact ends, LIGGGHTS rubs with mu |Fn| all the same (at e =
// 0.5 that makes a sixth more).
TEST_F(RecordedSphere, GrazingSlidesWithTheTrueFriction) {
  const double angle = 14.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d velocity(std::cos(angle), 0.0, -std::sin(angle));
  const Recording recording = thrown(square_mill(1.0), velocity);
  const double impulse = sphere_mass * (velocity.x() - last_velocity(recording).x());
  const double expected = 0.3 * 2.0 * sphere_mass * std::sin(angle);
  RecordProperty("impulse_share", fmt::format("{:.5f}", impulse / expected));
  EXPECT_NEAR(impulse, expected, 0.002 * expected);
  // The same impulse slows the surface by 1 + 5/2 of what it slows the centre.
  const double dissipated = impulse * (velocity.x() - 0.5 * 3.5 * impulse / sphere_mass);
  EXPECT_NEAR(sum(recording, Measure::shear_dissipation), dissipated, 0.002 * dissipated);
  EXPECT_NEAR(0.3 * sum(recording, Measure::sliding_work), dissipated, 0.002 * dissipated);
}

// Held from rolling and dragged 0.2 m: sliding work m g s, of which friction dissipates mu; and no
// impact, because it touches from before the first step.
TEST_F(RecordedSphere, DraggedDissipatesFrictionTimesDistance) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 20000, 1};
  const Eigen::Vector3d velocity(-0.3, 0.4, 0.0);
  const Recording recording =
      record_sphere(mill, steps, resting(mill, -0.2 * velocity, velocity), drag_without_rolling);
  const double work = sphere_mass * gravity * 0.2;
  EXPECT_NEAR(sum(recording, Measure::sliding_work), work, 1e-3 * work);
  EXPECT_NEAR(sum(recording, Measure::path_work), work, 1e-3 * work);
  EXPECT_NEAR(sum(recording, Measure::shear_dissipation), 0.3 * work, 3e-3 * work);
  ASSERT_EQ(recording.collisions.size(), 1u);
  EXPECT_EQ(recording.collisions.front().unfinished, wear::Unfinished::both);
  EXPECT_NEAR(recording.collisions.front().slip_distance, 0.2, 1e-3);
}

// Rocked by half of what friction can hold, 20 times: the spring between the surfaces moves to and
// fro, its damper takes some of the work, and nothing slides.
TEST_F(RecordedSphere, HeldByFrictionDoesNotSlide) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 20000, 1};
  const Recording recording =
      record_sphere(mill, steps, resting(mill, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()),
                    fmt::format("unfix integrate\nfix integrate all nve\n"
                                "variable rock equal {:.9g}*sin(2.0*PI*50.0*step*2e-5)\n"
                                "fix rock all addforce v_rock 0.0 0.0\n",
                                0.5 * 0.3 * sphere_mass * gravity));
  EXPECT_GT(sum(recording, Measure::samples), 19000.0);
  const double damped = sum(recording, Measure::shear_dissipation);
  EXPECT_GT(damped, 0.0) << "the damping of the spring";
  RecordProperty("slid_share",
                 fmt::format("{:.6f}", 0.3 * sum(recording, Measure::sliding_work) / damped));
  EXPECT_LT(std::abs(0.3 * sum(recording, Measure::sliding_work)), 0.02 * damped);
  EXPECT_LT(sum(recording, Measure::path_work), 0.001 * damped);
}

TEST_F(RecordedSphere, RollingDissipatesNothing) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 20000, 1};
  const Eigen::Vector3d velocity(0.3, 0.4, 0.0);
  Launch launch = resting(mill, -0.2 * velocity, velocity);
  launch.spin = Eigen::Vector3d::UnitZ().cross(velocity) / sphere_radius;
  const Recording recording = record_sphere(mill, steps, launch);
  const double slid = sphere_mass * gravity * 0.2;
  RecordProperty("work_share", fmt::format("{:.6f}", sum(recording, Measure::sliding_work) / slid));
  EXPECT_LT(sum(recording, Measure::sliding_work), 0.001 * slid);
  EXPECT_LT(std::abs(sum(recording, Measure::shear_dissipation)), 0.001 * slid);
  EXPECT_EQ(recording.collisions.size(), 1u);
}

// Held in place and spun at 20 rad/s for 0.2 s, the surface slips by omega R.
TEST_F(RecordedSphere, SpinningInPlaceSlipsBySpinTimesRadius) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 10000, 1};
  Launch launch = resting(mill, {0.0, 0.05, 0.0}, Eigen::Vector3d::Zero());
  launch.spin = {0.0, 20.0, 0.0};
  const Recording recording = record_sphere(mill, steps, launch, drag_without_rolling);
  const double work = sphere_mass * gravity * 20.0 * sphere_radius * 0.2;
  EXPECT_NEAR(sum(recording, Measure::sliding_work), work, 0.005 * work);
  EXPECT_NEAR(sum(recording, Measure::shear_dissipation), 0.3 * work, 0.005 * work);
}

// A sphere dragged aslant from one rank to the next, across the mill and along it, and through the
// periodic edge: one collision, and the same sums as on one rank.
TEST_F(RecordedSphere, ChangesRanksWithinOneCollision) {
  const Case mill = square_mill();
  const StretchSteps steps{2e-5, 0, 12000, 1};
  const Launch launch = resting(mill, {0.05, 0.02, 0.0}, {-0.5, 0.4, 0.0});
  const Recording one = record_sphere(mill, steps, launch, drag_without_rolling, 1);
  const Recording four = record_sphere(mill, steps, launch, drag_without_rolling, 4);
  ASSERT_EQ(one.collisions.size(), 1u);
  ASSERT_EQ(four.collisions.size(), 1u);
  EXPECT_NEAR(four.collisions.front().sliding_work, one.collisions.front().sliding_work,
              1e-9 * one.collisions.front().sliding_work);
  for (std::size_t m = 0; m < measure_count; ++m) {
    const auto measure = static_cast<Measure>(m);
    EXPECT_NEAR(sum(four, measure), sum(one, measure), 1e-9 * std::abs(sum(one, measure)))
        << measure_names[m];
  }
}

}  // namespace
}  // namespace millwear::trial
