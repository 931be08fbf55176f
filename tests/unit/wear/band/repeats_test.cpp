#include "wear/band/repeats.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "wear/band/life_band.h"

namespace millwear::wear {
namespace {

TEST(Repeats, HaveTheScatterOfASampleAndTheRootMeanSquareOfTheErrors) {
  const auto repeats = repeats_of(std::array{1.0, 2.0, 6.0}, std::array{1.0, 2.0, 2.0});
  EXPECT_DOUBLE_EQ(repeats.mean, 3.0);
  EXPECT_DOUBLE_EQ(repeats.scatter, std::sqrt(7.0));
  EXPECT_DOUBLE_EQ(repeats.predicted_error, std::sqrt(3.0));
}

TEST(Repeats, OfOneHaveNoScatter) {
  const auto repeats = repeats_of(std::array{2.0}, std::array{0.5});
  EXPECT_DOUBLE_EQ(repeats.mean, 2.0);
  EXPECT_TRUE(std::isnan(repeats.scatter));
  EXPECT_DOUBLE_EQ(repeats.predicted_error, 0.5);
}

TEST(Repeats, OfNothingAreNone) {
  EXPECT_THROW(static_cast<void>(repeats_of({}, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(repeats_of(std::array{1.0}, {})), std::logic_error);
}

TEST(StandardErrorOf, ABandIsItsHalfWidthOverTheNormalQuantile) {
  EXPECT_DOUBLE_EQ(standard_error_of({10.0 - 1.96 * 3.0, 10.0 + 1.96 * 3.0}), 3.0);
}

}  // namespace
}  // namespace millwear::wear
