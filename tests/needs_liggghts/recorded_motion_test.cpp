#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "liggghts_inputs/decks/deck.h"
#include "mill/case/time_step.h"
#include "tests/needs_liggghts/mill_trial.h"
#include "tests/needs_liggghts/sphere_trial.h"
#include "wear/record/charge_motion.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;
using wear::ChargePart;

class RecordedMotion : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

double part(const Recording& recording, ChargePart which) {
  return recording.record.motion->census.row(static_cast<Eigen::Index>(which)).sum();
}
double share(const Recording& recording, ChargePart which, ChargePart whole) {
  return part(recording, which) / part(recording, whole);
}
double hit_mass(const Recording& recording) {
  return recording.record.motion->plate.mass.sum() + recording.record.motion->lifter.mass.sum();
}
double hit_energy(const Recording& recording) {
  return recording.record.motion->plate.energy.sum() + recording.record.motion->lifter.energy.sum();
}

/// 0.1 ms off the floor.
Launch thrown_from(const Eigen::Vector3d& velocity, double x = 0.02) {
  const double clearance = 1e-4 * std::abs(velocity.z());
  return {{x, 0.03, floor_level + sphere_radius + clearance}, velocity, Eigen::Vector3d::Zero()};
}

// 30 mm of steel at 1 m/s and 60 degrees onto the floor: its mass and m v^2 / 2, under the axis but
// for 20 mm to the falling side, and once, though it touches for hundreds of steps.
TEST_F(RecordedMotion, OfAThrownSphereIsOneHitOfItsMassAndEnergy) {
  const Eigen::Vector3d velocity(0.5, 0.0, -std::sqrt(0.75));
  const auto recording = record_sphere(square_mill(), {5e-7, 0, 5000, 1}, thrown_from(velocity));
  EXPECT_NEAR(hit_mass(recording), sphere_mass, 1e-9 * sphere_mass);
  EXPECT_NEAR(hit_energy(recording), 0.5 * sphere_mass, 2e-3 * 0.5 * sphere_mass);
  const double degrees = std::atan2(-0.02, 0.2) * 180.0 / std::numbers::pi;
  const auto row = static_cast<Eigen::Index>(std::floor(degrees + 180.0));
  EXPECT_EQ(recording.record.motion->plate.mass.row(row).sum() +
                recording.record.motion->lifter.mass.row(row).sum(),
            hit_mass(recording));
}

TEST_F(RecordedMotion, OfASlowSphereIsNoHit) {
  const auto recording =
      record_sphere(square_mill(), {5e-7, 0, 5000, 1}, thrown_from({2.0, 0.0, -0.45}));
  EXPECT_EQ(recording.collisions.size(), 1U);
  EXPECT_EQ(hit_mass(recording), 0.0);
}

// Into the corner of floor and wall at once: two collisions, one hit.
TEST_F(RecordedMotion, OfASphereThrownIntoACornerIsOneHit) {
  Launch launch = thrown_from({1.0, 0.0, -1.0});
  launch.centre.x() = -launch.centre.z();
  const auto recording =
      record_sphere(square_mill(), {5e-7, 0, 5000, 1}, launch, "unfix gravity\n");
  EXPECT_EQ(recording.collisions.size(), 2U);
  EXPECT_NEAR(hit_mass(recording), sphere_mass, 1e-9 * sphere_mass);
}

// A sphere that rolls along the floor into the wall was never in flight.
TEST_F(RecordedMotion, OfASphereThatRollsIntoAWallIsNoHit) {
  const Case mill = square_mill();
  const Eigen::Vector3d velocity(2.0, 0.0, 0.0);
  Launch launch = resting(mill, {0.18, 0.03, 0.0}, velocity);
  launch.spin = Eigen::Vector3d::UnitZ().cross(velocity) / sphere_radius;
  const auto recording = record_sphere(mill, {5e-7, 0, 10000, 1}, launch);
  EXPECT_EQ(recording.collisions.size(), 2U);
  EXPECT_EQ(hit_mass(recording), 0.0);
}

TEST_F(RecordedMotion, FallingIsAirborneAndLyingIsNot) {
  const Case mill = square_mill();
  const auto falling = record_sphere(mill, {1e-5, 0, 5000, 1},
                                     {{0.0, 0.03, 0.1}, {0.1, 0.0, 0.0}, Eigen::Vector3d::Zero()});
  EXPECT_EQ(share(falling, ChargePart::airborne, ChargePart::all), 1.0);
  const auto lying = record_sphere(mill, {1e-5, 0, 5000, 1},
                                   resting(mill, {0.03, 0.02, 0.0}, Eigen::Vector3d::Zero()));
  EXPECT_EQ(share(lying, ChargePart::airborne, ChargePart::all), 0.0);
}

/// The small mill after four pitches.
class RecordedMillMotion : public RecordedMotion {
 protected:
  void SetUp() override {
    RecordedMotion::SetUp();
    if (IsSkipped()) return;
    mix(mill_, {plan_.time_step, 4 * plan_.steps_per_pitch, 0, 20}, scratch_.stage("mix"), 1);
  }

  Case mill_ = small_mill(ContactPath::recorder);
  const StepPlan plan_ = plan_steps(mill_);
  const ScratchFolder scratch_;
};

/// What a dump holds at each of its steps.
std::map<long, std::vector<std::vector<double>>> rows_by_step(const std::filesystem::path& file) {
  std::map<long, std::vector<std::vector<double>>> steps;
  std::istringstream text(text_of(file));
  long step = 0;
  bool in_rows = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("ITEM:")) {
      in_rows = line.starts_with("ITEM: ATOMS") || line.starts_with("ITEM: ENTRIES");
      if (line != "ITEM: TIMESTEP") continue;
      std::getline(text, line);
      step = std::stol(line);
      steps[step];
    } else if (in_rows) {
      std::istringstream words(line);
      steps[step].emplace_back(std::istream_iterator<double>(words),
                               std::istream_iterator<double>());
    }
  }
  return steps;
}

/// Has the deck dump lines of its own before its measurement.
ChangeDeck with_dumps(const std::string& lines) {
  return [lines](const std::filesystem::path& folder) {
    const auto deck = folder / liggghts::file_names::deck;
    std::string text = text_of(deck);
    text.insert(text.find("thermo_style"), lines);
    write_text(deck, text);
  };
}

// Counted anew from LIGGGHTS's own dump of places, velocities and forces.
TEST_F(RecordedMillMotion, CountsThePartsThatTheDumpsHold) {
  mill_.wear.time_blocks = 4;
  const StretchSteps steps{plan_.time_step, 500, 800, 1};  // a census every 50 steps
  const auto folder = scratch_.stage("parts");
  const auto recording =
      record(mill_, steps, mill_.liner, folder, "mix", 2,
             with_dumps("dump parts all custom 50 parts.dump x z vx vy vz fx fy fz mass\n"
                        "dump_modify parts format \"%.17g %.17g %.17g %.17g %.17g %.17g %.17g "
                        "%.17g %.17g\"\n"));
  const double plate_speed = mill_.speed * mill_.liner.sector.plate_radius;
  const double crest = mill_.liner.sector.plate_radius - 0.025;
  double all = 0.0, airborne = 0.0, ascending = 0.0, locked = 0.0, between = 0.0, packed = 0.0;
  for (const auto& [step, rows] : rows_by_step(folder / "parts.dump"))
    for (const auto& row : rows) {
      if (step <= 500) continue;
      const double mass = row[8];
      const double weight = mass * 9.81;
      all += mass;
      if (std::hypot(row[5], row[6], row[7] + weight) < 1e-6 * weight) {
        airborne += mass;
        continue;
      }
      const double along_x = mill_.speed * row[1];
      const double along_z = -mill_.speed * row[0];
      if (row[2] * along_x + row[4] * along_z <= 0.0) continue;
      ascending += mass;
      const bool slow = std::hypot(row[2] - along_x, row[3], row[4] - along_z) < 0.05 * plate_speed;
      const bool low = std::hypot(row[0], row[1]) > crest;
      if (slow) locked += mass;
      if (low) between += mass;
      if (slow && low) packed += mass;
    }
  EXPECT_GT(airborne, 0.0);
  EXPECT_GT(packed, 0.0);
  EXPECT_LT(locked, ascending);
  EXPECT_NEAR(all, 16.0 * totals(mill_).mass, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::all), all, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::airborne), airborne, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::ascending), ascending, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::locked), locked, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::between), between, 1e-9 * all);
  EXPECT_NEAR(part(recording, ChargePart::between_locked), packed, 1e-9 * all);
}

// Found anew from the list of all collisions with the liner and LIGGGHTS's own list of the pairs of
// particles that touch, step by step.
TEST_F(RecordedMillMotion, HitsTheBareLinerWhereNoPairTouches) {
  const StretchSteps steps{plan_.time_step, 500, 4000, 1};
  const auto folder = scratch_.stage("hits");
  const auto recording = record(mill_, steps, mill_.liner, folder, "mix", 1,
                                with_dumps("compute touching all pair/gran/local id\n"
                                           "dump pairs all local 1 pairs.dump c_touching[1] "
                                           "c_touching[2]\n"));
  std::map<long, std::set<long>> touching;
  for (const auto& [step, rows] : rows_by_step(folder / "pairs.dump"))
    for (const auto& row : rows)
      for (const int column : {0, 1}) touching[step].insert(std::lround(row[column]));
  const auto step_of = [&](double time) { return 500 + std::lround(time / plan_.time_step); };
  double mass = 0.0, energy = 0.0, crowded = 0.0;
  for (const auto& hit : recording.collisions) {
    if (hit.unfinished == wear::Unfinished::began_before ||
        hit.unfinished == wear::Unfinished::both ||
        hit.impact_speed * std::sin(hit.impact_angle) <= 0.5)
      continue;
    const bool was_there = std::ranges::any_of(recording.collisions, [&](const auto& other) {
      return &other != &hit && other.particle == hit.particle &&
             step_of(other.start) < step_of(hit.start) &&
             step_of(other.end) >= step_of(hit.start) - 1;
    });
    const double ball = particle_mass(mill_, mill_.charge.classes[hit.particle_class]);
    if (was_there || touching[step_of(hit.start)].contains(hit.particle)) {
      crowded += ball;
      continue;
    }
    mass += ball;
    energy += 0.5 * ball * hit.impact_speed * hit.impact_speed;
  }
  RecordProperty("balls", fmt::format("{} {}", mass / sphere_mass, crowded / sphere_mass));
  EXPECT_GT(mass, 5.0 * sphere_mass);
  EXPECT_GT(crowded, 0.0);
  EXPECT_NEAR(hit_mass(recording), mass, 1e-9 * mass);
  EXPECT_NEAR(hit_energy(recording), energy, 1e-6 * energy);
}

// Between tall lifters the charge is packed; over low ones it slides.
TEST_F(RecordedMillMotion, IsMoreLockedBetweenTallLiftersThanOverLowOnes) {
  const auto dead_zone = [&](const LinerProfile& liner, const std::string& stage) {
    const StretchSteps steps{plan_.time_step, plan_.steps_per_pitch, 3 * plan_.steps_per_pitch, 20};
    const auto recording = record(mill_, steps, liner, scratch_.stage(stage), "mix", 1);
    return share(recording, ChargePart::locked, ChargePart::ascending);
  };
  const double tall = dead_zone(mill_.liner, "tall");
  LinerProfile low = mill_.liner;
  for (auto& node : low.nodes) {
    const double height = low.sector.plate_radius - radius_of(low.sector, node);
    node = point_at(low.sector, low.sector.plate_radius - 0.1 * height, angle_of(low.sector, node));
  }
  const double flat = dead_zone(low, "low");
  RecordProperty("dead_zone", fmt::format("{:.3f} {:.3f}", tall, flat));
  EXPECT_GT(tall, flat);
}

}  // namespace
}  // namespace millwear::trial
