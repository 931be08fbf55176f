#include "wear/numerics/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear::wear {
namespace {

// The first outputs of the published splitmix64.c from the state 0.
TEST(RandomStream, IsTheSameEverywhere) {
  EXPECT_EQ(random_bits(0, 0), 0xe220a8397b1dcdafU);
  EXPECT_EQ(random_bits(0, 1), 0x6e789e6aa1b965f4U);
  EXPECT_EQ(random_bits(0, 2), 0x06c45d188009454fU);
}

TEST(RandomStream, DependsOnTheSeed) { EXPECT_NE(random_bits(1, 0), random_bits(2, 0)); }

// Of 1e5 numbers the mean is known to 0.0032, the variance to 0.0045, the fourth moment to 0.03.
TEST(RandomStream, MakesStandardNormalNumbers) {
  const Eigen::ArrayXd z = standard_normals(1000, 100, 7).reshaped();
  EXPECT_NEAR(z.mean(), 0.0, 0.013);
  EXPECT_NEAR(z.square().mean(), 1.0, 0.018);
  EXPECT_NEAR(z.pow(4).mean(), 3.0, 0.13);
  EXPECT_NEAR((z.head(99999) * z.tail(99999)).mean(), 0.0, 0.013);
}

TEST(RandomStream, GoesOnWhereItWasLeft) {
  const Eigen::MatrixXd all = standard_normals(10, 3, 5);
  EXPECT_EQ(all.col(2), standard_normals(10, 1, 5, 20).col(0));
}

}  // namespace
}  // namespace millwear::wear
