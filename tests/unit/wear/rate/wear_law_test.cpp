#include "wear/rate/wear_law.h"

#include <gtest/gtest.h>

#include "mill/base/failure.h"
#include "tests/support/example_case.h"

namespace millwear::wear {
namespace {

/// Balls of 50 mm, ore of 30 and 20 mm; materials 0 and 1.
const Charge charge = example_case().charge;

/// Bins of 0.1 m on a slice of 0.1 m, i.e. 1e-2 m2, three classes, two time blocks, empty.
WallLoad empty_load(Eigen::Index bins, int rows, double duration) {
  WallLoad load{};
  load.slice_length = 0.1;
  load.rows = rows;
  load.duration = duration;
  load.bin_edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, 0.1 * static_cast<double>(bins));
  load.class_count = charge.classes.size();
  load.block_count = 2;
  load.values.fill(Eigen::MatrixXd::Zero(bins, 6));
  return load;
}

/// One bin; the balls' `measure` in both blocks.
WallLoad one_bin_load(Measure measure, double first_block, double second_block, int rows = 1,
                      double duration = 4.0) {
  WallLoad load = empty_load(1, rows, duration);
  load.values[index_of(measure)].leftCols(2) << first_block, second_block;
  return load;
}

/// A bin a row, the classes' energies [J] in its first time block.
WallLoad load_of(Measure measure, const Eigen::MatrixX3d& by_class) {
  WallLoad load = empty_load(by_class.rows(), 1, 1.0);
  for (Eigen::Index kind = 0; kind < 3; ++kind) {
    load.values[index_of(measure)].col(2 * kind) = by_class.col(kind);
  }
  return load;
}

LawWeights law(WearLaw which, double coefficient = 1e-12) {
  return weights_of({which, coefficient}, charge.classes);
}

/// Steel lost in the whole load on all lifters [m3].
double volume(const LawWeights& weights, const WallLoad& load) {
  return depth_rate(weights, load).dot(load.bin_area()) * load.rows * load.duration;
}

// A block pressed with 100 N and dragged 2 m at k = 1e-12 1/Pa loses 2e-10 m3: V = k F s.
TEST(Archard, LosesForceTimesDistance) {
  EXPECT_DOUBLE_EQ(
      volume(law(WearLaw::archard), one_bin_load(Measure::sliding_work, 100.0 * 2.0, 0.0)), 2e-10);
}

// The same work shared by five lifters, or taken in half the time.
TEST(WearLaw, IsARatePerLifterAndSecond) {
  const auto rate = [](int rows, double duration) {
    return depth_rate(law(WearLaw::archard),
                      one_bin_load(Measure::sliding_work, 200.0, 0.0, rows, duration))[0];
  };
  EXPECT_DOUBLE_EQ(rate(5, 4.0), rate(1, 4.0) / 5.0);
  EXPECT_DOUBLE_EQ(rate(1, 2.0), rate(1, 4.0) * 2.0);
}

TEST(WearLaw, MeanOverBlocksIsTheWhole) {
  const auto load = one_bin_load(Measure::sliding_work, 150.0, 50.0, 3);
  const auto blocks = depth_rate_by_block(law(WearLaw::archard), load);
  EXPECT_DOUBLE_EQ(blocks(0, 0), 3.0 * blocks(0, 1));
  EXPECT_DOUBLE_EQ(blocks.row(0).mean(), depth_rate(law(WearLaw::archard), load)[0]);
}

// 50 J of its own measure at 2e-12 m3/J are 1e-10 m3, and 50 J of any other measure are nothing.
TEST(WearLaw, OfEachKindGoesWithItsOwnMeasureAlone) {
  const std::vector<std::pair<WearLaw, Measure>> kinds = {
      {WearLaw::archard, Measure::sliding_work},
      {WearLaw::finnie, Measure::finnie},
      {WearLaw::normal_dissipation, Measure::normal_dissipation},
      {WearLaw::excess_energy, Measure::excess_energy},
      {WearLaw::shear_dissipation, Measure::shear_dissipation},
      {WearLaw::incident_energy, Measure::incident_energy},
      {WearLaw::shear_impact_energy, Measure::shear_dissipation}};
  for (const auto& [kind, own] : kinds) {
    for (std::size_t m = 0; m < measure_count; ++m) {
      const auto measure = static_cast<Measure>(m);
      EXPECT_DOUBLE_EQ(volume(law(kind, 2e-12), one_bin_load(measure, 50.0, 0.0)),
                       measure == own ? 1e-10 : 0.0)
          << name_of(kind) << " on " << measure_names[m];
    }
  }
}

// A ball of 1 kg at 2 m/s brings 2 J: at 1e-11 m3/J it takes 2e-11 m3.
TEST(IncidentEnergy, LosesTheKineticEnergyOfImpact) {
  EXPECT_DOUBLE_EQ(volume(law(WearLaw::incident_energy, 1e-11),
                          one_bin_load(Measure::incident_energy, 0.5 * 1.0 * 2.0 * 2.0, 0.0)),
                   2e-11);
}

// 1 mm a year is 3.1688e-11 m/s, on a bin that nothing touched as on any other.
TEST(Corrosion, IsTheSameEverywhereAndNeedsNoLoad) {
  const double rate = 1e-3 / (365.25 * 24.0 * 3600.0);
  const LawWeights weights = weights_of({WearLaw::corrosion, 0.0, rate}, charge.classes);
  const WallLoad load = empty_load(3, 2, 5.0);
  for (const double depth : depth_rate(weights, load)) EXPECT_EQ(depth, rate);
  const Eigen::MatrixXd blocks = depth_rate_by_block(weights, load);
  EXPECT_EQ(blocks.minCoeff(), rate);
  EXPECT_EQ(blocks.maxCoeff(), rate);
}

// 100 J from each class. Balls: 1e-12. Ore: 3e-12. Particles up to 20 mm: 5e-12 more.
// V = 100 (1 + 3 + (3 + 5)) 1e-12 = 1.2e-9 m3.
TEST(WearLaw, TakesEachMechanismFromItsOwnParticlesAndAdds) {
  const std::vector<WearMechanism> mechanisms = {{WearLaw::archard, 1e-12, 0.0, std::size_t{0}},
                                                 {WearLaw::archard, 3e-12, 0.0, std::size_t{1}},
                                                 {WearLaw::archard, 5e-12, 0.0, {}, {}, 0.02}};
  const LawWeights weights = weights_of(mechanisms, charge.classes);
  const auto work = weights.per_energy.row(index_of(Measure::sliding_work));
  EXPECT_DOUBLE_EQ(work[0], 1e-12);
  EXPECT_DOUBLE_EQ(work[1], 3e-12);
  EXPECT_DOUBLE_EQ(work[2], 8e-12);
  const WallLoad load = load_of(Measure::sliding_work, Eigen::RowVector3d(100.0, 100.0, 100.0));
  EXPECT_DOUBLE_EQ(volume(weights, load), 1.2e-9);
}

// Bins of 6, -2 and 2 J: their sum, 6 J, stays, and no bin gains steel: 6 * 6/8, 0, 2 * 6/8 J.
TEST(NormalDissipation, IsNeverBelowZeroAndKeepsItsSum) {
  const WallLoad load = load_of(Measure::normal_dissipation,
                                Eigen::Vector3d(6.0, -2.0, 2.0) * Eigen::RowVector3d(1, 0, 0));
  const Eigen::VectorXd rate = depth_rate(law(WearLaw::normal_dissipation), load);
  EXPECT_DOUBLE_EQ(rate[0] * 1e-2, 4.5e-12);
  EXPECT_EQ(rate[1], 0.0);
  EXPECT_DOUBLE_EQ(rate[2] * 1e-2, 1.5e-12);
}

// A class whose sum is below zero wears nothing, and takes nothing from another one.
TEST(NormalDissipation, OfAClassThatGivesMoreThanItTakesWearsNothing) {
  Eigen::MatrixX3d energy(2, 3);
  energy << 5.0, 1.0, 0.0,  //
      3.0, -2.0, 0.0;
  const Eigen::VectorXd rate =
      depth_rate(law(WearLaw::normal_dissipation), load_of(Measure::normal_dissipation, energy));
  EXPECT_DOUBLE_EQ(rate[0] * 1e-2, 5e-12);
  EXPECT_DOUBLE_EQ(rate[1] * 1e-2, 3e-12);
}

// The bin of -3 + 1 = -2 J counts as 0; its blocks, 0.5 s each, still differ by their 4 J.
TEST(NormalDissipation, KeepsTheScatterOfItsBlocks) {
  WallLoad load = empty_load(2, 1, 1.0);
  load.values[index_of(Measure::normal_dissipation)].leftCols(2) << 4.0, 4.0, -3.0, 1.0;
  const LawWeights weights = law(WearLaw::normal_dissipation);
  const Eigen::MatrixXd blocks = depth_rate_by_block(weights, load);
  const Eigen::VectorXd rate = depth_rate(weights, load);
  EXPECT_DOUBLE_EQ(blocks(1, 0) * 1e-2, -2.0 * 1e-12 / 0.5);
  EXPECT_DOUBLE_EQ(blocks(1, 1) * 1e-2, 2.0 * 1e-12 / 0.5);
  EXPECT_EQ(rate[1], 0.0);
  EXPECT_DOUBLE_EQ(blocks.row(0).mean(), rate[0]);
  EXPECT_DOUBLE_EQ(rate[0] * 1e-2, 6e-12);
}

// Twice the coefficient is twice the rate, also where bins were cut; mechanisms add to the whole.
TEST(WearLaw, IsLinearInItsCoefficients) {
  Eigen::MatrixX3d energy(3, 3);
  energy << 6.0, 1.0, 2.0,  //
      -2.0, 4.0, -1.0,      //
      2.0, -1.0, 3.0;
  const WallLoad load = load_of(Measure::normal_dissipation, energy);
  const WearMechanism balls{WearLaw::normal_dissipation, 1e-12, 0.0, std::size_t{0}};
  const WearMechanism ore{WearLaw::normal_dissipation, 4e-12, 0.0, std::size_t{1}};
  const WearMechanism rust{WearLaw::corrosion, 0.0, 1e-11};
  const std::vector<WearMechanism> mechanisms = {balls, ore, rust};
  LawWeights whole = weights_of(mechanisms, charge.classes);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3);
  for (const auto& mechanism : mechanisms) {
    sum += depth_rate(weights_of(mechanism, charge.classes), load);
  }
  const Eigen::VectorXd once = depth_rate(whole, load);
  EXPECT_TRUE(once.isApprox(sum, 1e-14));
  whole.per_energy *= 2.0;
  whole.corrosion *= 2.0;
  EXPECT_TRUE(depth_rate(whole, load).isApprox(2.0 * once, 1e-14));
}

TEST(WearLaw, RefusesABinWithoutAreaAndAnotherCharge) {
  auto load = one_bin_load(Measure::sliding_work, 1.0, 1.0);
  load.bin_edges[1] = 0.0;
  EXPECT_THROW(static_cast<void>(depth_rate(law(WearLaw::archard), load)), InputError);
  load = one_bin_load(Measure::sliding_work, 1.0, 1.0);
  load.class_count = 2;
  EXPECT_THROW(static_cast<void>(depth_rate(law(WearLaw::archard), load)), InputError);
  EXPECT_THROW(static_cast<void>(depth_rate_by_block(law(WearLaw::archard), load)), InputError);
}

}  // namespace
}  // namespace millwear::wear
