#include "mill/load/drift_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear {
namespace {

const MixingDrift slow{{0.021, 0.05}, {0.008, 0.15}};

TEST(DriftText, SaysTorqueThenEnergyEachWithItsLimit) {
  EXPECT_EQ(spoken_drift(slow),
            "torque drifts by 2.1 % (limit 5 %), kinetic energy by 0.8 % (limit 15 %)");
  EXPECT_EQ(spoken_torque_drift(slow), "torque drifts by 2.1 %");
  EXPECT_EQ(spoken_drift({}), "too early to tell a drift");
  EXPECT_EQ(spoken_torque_drift({}), "too early to tell a drift");
}

TEST(DriftText, NamesTheClassThatDriftsMost) {
  MixingDrift sorting = slow;
  sorting.on_liner = ClassDrift{2, {0.04, 0.07}};
  EXPECT_EQ(spoken_drift(sorting),
            spoken_drift(slow) + ", class 3 on the liner by 4 % (limit 7 %)");
  std::optional<MixingDrift> read;
  ASSERT_TRUE(read_drift(spoken_drift(sorting), read));
  ASSERT_TRUE(read->on_liner);
  EXPECT_EQ(read->on_liner->particle_class, 2U);
  EXPECT_DOUBLE_EQ(read->on_liner->share.relative, 0.04);
  EXPECT_DOUBLE_EQ(read->on_liner->share.limit, 0.07);
}

TEST(DriftText, IsReadBack) {
  std::optional<MixingDrift> read;
  ASSERT_TRUE(read_drift(spoken_drift(slow), read));
  ASSERT_TRUE(read);
  EXPECT_DOUBLE_EQ(read->torque.relative, 0.021);
  EXPECT_DOUBLE_EQ(read->torque.limit, 0.05);
  EXPECT_DOUBLE_EQ(read->kinetic_energy.relative, 0.008);
  EXPECT_DOUBLE_EQ(read->kinetic_energy.limit, 0.15);
  ASSERT_TRUE(read_drift(spoken_drift({}), read));
  EXPECT_FALSE(read);
}

// A mean of zero: nobody knows how far the torque drifts.
TEST(DriftText, IsReadBackWhereADriftIsNotFinite) {
  const MixingDrift endless{{INFINITY, 0.05}, {std::nan(""), 0.05}};
  std::optional<MixingDrift> read;
  ASSERT_TRUE(read_drift(spoken_drift(endless), read));
  EXPECT_TRUE(std::isinf(read->torque.relative));
  EXPECT_TRUE(std::isnan(read->kinetic_energy.relative));
}

TEST(DriftText, IsNoOtherText) {
  std::optional<MixingDrift> read = slow;
  EXPECT_FALSE(read_drift("torque drifts by 2.1 % (limit 5 %)", read));
  EXPECT_FALSE(read);
  EXPECT_FALSE(read_drift(spoken_drift(slow) + ".", read));
  EXPECT_FALSE(read_drift("", read));
}

}  // namespace
}  // namespace millwear
