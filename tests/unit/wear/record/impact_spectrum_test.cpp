#include "wear/record/impact_spectrum.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace millwear::wear {
namespace {

TEST(ImpactSpectrum, HasTenClassesToTheDecade) {
  const Eigen::VectorXd edges = energy_edges();
  ASSERT_EQ(edges.size(), 141);
  EXPECT_DOUBLE_EQ(edges[0], 1e-9);
  EXPECT_DOUBLE_EQ(edges[60], 1e-3);
  EXPECT_DOUBLE_EQ(edges[90], 1.0);
  EXPECT_DOUBLE_EQ(edges[91], std::pow(10.0, 0.1));
  EXPECT_DOUBLE_EQ(edges[140], 1e5);
}

TEST(ImpactSpectrum, AClassBeginsAtItsEdge) {
  const Eigen::VectorXd edges = energy_edges();
  for (Eigen::Index i = 0; i < energy_classes; ++i) {
    EXPECT_EQ(energy_class(edges[i]), i);
    EXPECT_EQ(energy_class(std::nextafter(edges[i + 1], 0.0)), i);
  }
}

// 1 J is class 90, 1.1 J too; 1.26 J, just above 10^0.1 = 1.2589 J, is class 91.
TEST(ImpactSpectrum, FindsTheClassOfAnEnergy) {
  EXPECT_EQ(energy_class(1.0), 90);
  EXPECT_EQ(energy_class(1.1), 90);
  EXPECT_EQ(energy_class(1.26), 91);
  EXPECT_EQ(energy_class(1e-3), 60);
}

TEST(ImpactSpectrum, WhatLiesBeyondBelongsToTheFirstOrTheLastClass) {
  EXPECT_EQ(energy_class(0.0), 0);
  EXPECT_EQ(energy_class(-5.0), 0);
  EXPECT_EQ(energy_class(1e-20), 0);
  EXPECT_EQ(energy_class(std::nan("")), 0);
  EXPECT_EQ(energy_class(1e5), 139);
  EXPECT_EQ(energy_class(1e30), 139);
  EXPECT_EQ(energy_class(std::numeric_limits<double>::infinity()), 139);
}

RC_GTEST_PROP(ImpactSpectrum, AnEnergyLiesBetweenTheEdgesOfItsClass, ()) {
  const double energy = std::pow(10.0, *rc::gen::inRange(-90000, 50000) * 1e-4);
  const Eigen::VectorXd edges = energy_edges();
  const Eigen::Index i = energy_class(energy);
  RC_ASSERT(energy >= edges[i] || i == 0);
  RC_ASSERT(energy < edges[i + 1]);
}

TEST(ImpactSpectrum, CountsACollisionByBothItsEnergies) {
  ImpactSpectrum spectrum = empty_spectrum(3);
  add_collision(spectrum, 2, 1.1, 2e-3);
  add_collision(spectrum, 2, 1.2, 0.0);
  EXPECT_EQ(spectrum.normal_events(90, 2), 2.0);
  EXPECT_DOUBLE_EQ(spectrum.normal_energy(90, 2), 2.3);
  EXPECT_EQ(spectrum.shear_events(63, 2), 1.0);
  EXPECT_EQ(spectrum.shear_energy(63, 2), 2e-3);
  EXPECT_EQ(spectrum.shear_events(0, 2), 1.0);
  EXPECT_EQ(spectrum.normal_events.sum(), 2.0);
  EXPECT_EQ(spectrum.shear_events.sum(), 2.0);
}

TEST(ImpactSpectrum, SpectraAddUp) {
  ImpactSpectrum sum = empty_spectrum(2);
  add_collision(sum, 0, 1.0, 1e-3);
  sum.unfinished[1] = 2.0;
  ImpactSpectrum more = sum;
  add_collision(more, 1, 10.0, 1e-2);
  add_spectrum(sum, more);
  EXPECT_EQ(sum.normal_events(90, 0), 2.0);
  EXPECT_EQ(sum.normal_energy(100, 1), 10.0);
  EXPECT_EQ(sum.shear_events.sum(), 3.0);
  EXPECT_DOUBLE_EQ(sum.shear_energy.sum(), 1e-3 + 1e-3 + 1e-2);
  EXPECT_EQ(sum.unfinished[1], 4.0);
}

TEST(ImpactSpectrum, EveryPairOfClassesHasItsOwnColumn) {
  for (Eigen::Index classes = 1; classes <= 13; ++classes) {
    std::set<Eigen::Index> seen;
    for (Eigen::Index a = 0; a < classes; ++a)
      for (Eigen::Index b = a; b < classes; ++b) {
        const Eigen::Index column = pair_group(a, b, classes);
        EXPECT_EQ(column, pair_group(b, a, classes));
        EXPECT_EQ(column, std::ssize(seen)) << "in the order (0,0), (0,1), ... (1,1), ...";
        seen.insert(column);
      }
    EXPECT_EQ(std::ssize(seen), pair_groups(classes));
  }
}

}  // namespace
}  // namespace millwear::wear
