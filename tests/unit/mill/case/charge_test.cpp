#include "mill/case/charge.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mill/base/failure.h"

namespace millwear {
namespace {

TEST(Charge, VolumeOfASphere) {
  EXPECT_DOUBLE_EQ(sphere_volume(2.0), 4.0 / 3.0 * std::numbers::pi);
}

// 3 : 1 by volume of 0.1 and 0.05 m, 4 volumes of the large sphere: 3 large, 8 small.
TEST(Charge, CountsFollowTheShares) {
  const auto classes =
      counts_for_volume(1, {{0.1, 75.0}, {0.05, 25.0}}, 4.0 * sphere_volume(0.1), 0.0);
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].count, 3U);
  EXPECT_EQ(classes[1].count, 8U);
  EXPECT_EQ(classes[1].material, 1U);
}

// Cut at 0.06 m, the large spheres take the whole volume.
TEST(Charge, TruncationKeepsTheVolume) {
  const auto classes =
      counts_for_volume(0, {{0.1, 75.0}, {0.05, 25.0}}, 4.0 * sphere_volume(0.1), 0.06);
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].count, 4U);
}

TEST(Charge, NothingLeftIsRefused) {
  EXPECT_THROW(static_cast<void>(counts_for_volume(0, {{0.1, 1.0}}, 1.0, 0.2)), InputError);
  EXPECT_THROW(static_cast<void>(counts_for_volume(0, {{0.1, 0.0}}, 1.0, 0.0)), InputError);
  EXPECT_THROW(static_cast<void>(counts_for_volume(0, {{1e-9, 1.0}}, 1.0, 0.0)), InputError);
}

// Rounding each class to the nearest moves the volume by at most half a sphere a class.
RC_GTEST_PROP(Charge, VolumeIsKeptWithinRounding, ()) {
  std::vector<SieveClass> sieve;
  double slack = 0.0;
  for (int i = 0; i < 5; ++i) {
    sieve.push_back({0.1 / (1 + i), 1.0 + *rc::gen::inRange(0, 100)});
    slack += 0.5 * sphere_volume(sieve.back().size);
  }
  const double wanted = 0.01 + *rc::gen::inRange(0, 1000) * 1e-3;
  double volume = 0.0;
  for (const ParticleClass& c : counts_for_volume(0, sieve, wanted, 0.0)) {
    volume += static_cast<double>(c.count) * sphere_volume(c.diameter);
  }
  RC_ASSERT(std::abs(volume - wanted) <= slack * (1.0 + 1e-9));
}

}  // namespace
}  // namespace millwear
