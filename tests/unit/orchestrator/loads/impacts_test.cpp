#include "orchestrator/loads/impacts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

using ::testing::ElementsAre;

/// Two seconds of a mill of steel of 50 mm, ore of 30 and of 20 mm: class 1 hits the liner twice
/// with 1.1 and 1.2 J across and 2 mJ along it.
wear::LinerRecord record() {
  wear::LinerRecord made{};
  made.load.duration = 2.0;
  made.load.class_count = 3;
  made.load.block_count = 2;
  made.load.bin_edges = Eigen::VectorXd::LinSpaced(2, 0.0, 1.0);
  made.load.values.fill(Eigen::MatrixXd::Zero(1, 6));
  made.spectrum = wear::empty_spectrum(3);
  wear::add_collision(made.spectrum, 1, 1.1, 2e-3);
  wear::add_collision(made.spectrum, 1, 1.2, 2e-3);
  return made;
}

/// The same with one collision of class 0 with class 2 of 5 J and 0.5 J, in half a second.
wear::LinerRecord record_with_pairs() {
  auto made = record();
  made.pairs = wear::PairRecord{0.5, wear::empty_spectrum(6), 0.0, 0.0, 0.0};
  wear::add_collision(made.pairs->spectrum, wear::pair_group(2, 0, 3), 5.0, 0.5);
  return made;
}

TEST(ClassNames, AreTheMaterialAndTheDiameter) {
  EXPECT_THAT(class_names(example_case()), ElementsAre("steel_50mm", "ore_30mm", "ore_20mm"));
}

TEST(ClassNames, AreUniqueAndFitIntoATable) {
  auto mill = example_case();
  mill.materials[1].name = "ore, \"hard\"";
  mill.charge.classes[1].diameter = 0.0225;
  mill.charge.classes[2].diameter = 0.0225 * (1.0 + 1e-9);
  EXPECT_THAT(class_names(mill),
              ElementsAre("steel_50mm", "ore_ _hard__22.5mm", "ore_ _hard__22.5mm_2"));
}

// Two collisions of 2.3 J in all in 2 s are 1 a second and 1.15 W.
TEST(SpectrumRows, AreRatesWhereSomethingWasCounted) {
  const auto rows = spectrum_rows(4, record(), class_names(example_case()));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].cycle, 4);
  EXPECT_EQ(rows[0].contact, CollisionWith::liner);
  EXPECT_EQ(rows[0].class_a, "ore_30mm");
  EXPECT_EQ(rows[0].class_b, "");
  EXPECT_EQ(rows[0].direction, EnergyDirection::normal);
  EXPECT_DOUBLE_EQ(rows[0].energy_low, 1.0);
  EXPECT_DOUBLE_EQ(rows[0].energy_high, std::pow(10.0, 0.1));
  EXPECT_EQ(rows[0].events_per_second, 1.0);
  EXPECT_DOUBLE_EQ(rows[0].power, 1.15);
  EXPECT_EQ(rows[1].direction, EnergyDirection::shear);
  EXPECT_DOUBLE_EQ(rows[1].power, 2e-3);
}

// One in half a second is two a second.
TEST(SpectrumRows, OfParticlesNameBothClasses) {
  const auto rows = spectrum_rows(0, record_with_pairs(), class_names(example_case()));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2].contact, CollisionWith::particles);
  EXPECT_EQ(rows[2].class_a, "steel_50mm");
  EXPECT_EQ(rows[2].class_b, "ore_20mm");
  EXPECT_EQ(rows[2].events_per_second, 2.0);
  EXPECT_DOUBLE_EQ(rows[2].power, 10.0);
  EXPECT_DOUBLE_EQ(rows[3].power, 1.0);
}

// Four collisions of 2 J of kinetic energy in all: m v^2 / 2 = 0.5 J each.
TEST(Impacts, GiveEveryClassItsRateSpeedAndPower) {
  auto seen = record();
  const auto mill = example_case();
  seen.load.values[index_of(Measure::events)].row(0) << 9.0, 9.0, 3.0, 1.0, 9.0, 9.0;
  seen.load.values[index_of(Measure::incident_energy)].row(0) << 9.0, 9.0, 1.5, 0.5, 9.0, 9.0;
  seen.spectrum.unfinished[1] = 2.0;
  const Impacts impacts = impacts_of(4, seen, mill);
  ASSERT_EQ(impacts.liner.size(), 3U);
  const ImpactLine& ore = impacts.liner[1];
  EXPECT_EQ(ore.name, "ore 30 mm");
  EXPECT_EQ(ore.events_per_second, 1.0);
  EXPECT_DOUBLE_EQ(ore.normal_power, 1.15);
  EXPECT_DOUBLE_EQ(ore.shear_power, 2e-3);
  EXPECT_EQ(ore.unfinished_share, 0.5);
  EXPECT_EQ(ore.normal[90], 1.0);
  EXPECT_EQ(ore.shear[63], 1.0);
  EXPECT_DOUBLE_EQ(ore.impact_speed,
                   std::sqrt(2.0 * 0.5 / particle_mass(mill, mill.charge.classes[1])));
  EXPECT_TRUE(impacts.particles.empty());
}

TEST(Impacts, BetweenParticlesAreByPairOfMaterials) {
  const Impacts impacts = impacts_of(0, record_with_pairs(), example_case());
  ASSERT_EQ(impacts.particles.size(), 3U);
  EXPECT_EQ(impacts.particles[0].name, "steel on steel");
  EXPECT_EQ(impacts.particles[0].events_per_second, 0.0);
  EXPECT_EQ(impacts.particles[1].name, "steel on ore");
  EXPECT_EQ(impacts.particles[1].events_per_second, 2.0);
  EXPECT_DOUBLE_EQ(impacts.particles[1].normal_power, 10.0);
  EXPECT_EQ(impacts.particles[2].name, "ore on ore");
}

}  // namespace
}  // namespace millwear::orchestrator
