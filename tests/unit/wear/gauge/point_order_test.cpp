#include "wear/gauge/point_order.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace millwear::wear {
namespace {

using Curve = std::vector<Eigen::Vector2d>;

/// A lifter of 40 mm on a flat plate, a point every 10 mm.
Curve lifter() {
  Curve curve;
  for (int i = 0; i < 30; ++i) curve.emplace_back(0.01 * i, i > 10 && i < 18 ? 0.04 : 0.0);
  return curve;
}

TEST(PointOrder, IsThatOfASoundProfile) { EXPECT_FALSE(first_disorder(lifter(), 0.002)); }

TEST(PointOrder, FindsABlockThatIsReversed) {
  Curve curve = lifter();
  std::reverse(curve.begin() + 9, curve.begin() + 14);
  const auto disorder = first_disorder(curve, 0.002);
  ASSERT_TRUE(disorder);
  EXPECT_GE(disorder->first, 8U);
  EXPECT_LE(disorder->last, 14U);
}

// On the flat plate nothing crosses: the curve turns back.
TEST(PointOrder, FindsTwoPointsThatChangedPlaces) {
  Curve curve = lifter();
  std::swap(curve[4], curve[5]);
  const auto disorder = first_disorder(curve, 0.002);
  ASSERT_TRUE(disorder);
  EXPECT_EQ(disorder->first, 4U);
  EXPECT_EQ(disorder->last, 5U);
}

TEST(PointOrder, LeavesLoopsAloneThatNoiseMakes) {
  Curve curve = lifter();
  curve.insert(curve.begin() + 5, {{0.0405, 0.0}, {0.0402, 0.0002}, {0.0404, -0.0002}});
  EXPECT_FALSE(first_disorder(curve, 0.002));
  EXPECT_TRUE(first_disorder(curve, 0.0001));
}

}  // namespace
}  // namespace millwear::wear
