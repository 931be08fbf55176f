#include "wear/evolve/steel_cut.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace millwear::wear {
namespace {

const Polygon bottom = {{-1.0, -1.0}, {3.0, -1.0}};
/// Flat but for a bump of 0.05 m2.
const Polygon bump = {{-1.0, 0.0}, {0.0, 0.0}, {0.5, 0.1}, {1.0, 0.0}, {3.0, 0.0}};

bool has(const Polygon& surface, const Eigen::Vector2d& node) {
  return std::find(surface.begin(), surface.end(), node) != surface.end();
}

// The cut runs from a point of the surface straight under the bump, wider and wider, and out again
// behind it. The bump hangs on the point where the cut begins.
TEST(SteelCut, DropsWhatHangsOnAPoint) {
  const SteelCut left = cut(bump, bottom, {{{0.0, 0.0}, {2.0, -0.1}, {2.0, 0.0}, {1.0, 0.0}}});
  ASSERT_EQ(left.dropped.size(), 1U);
  EXPECT_FALSE(has(left.surface, {0.5, 0.1}));
  EXPECT_EQ(std::ranges::count(left.surface, Eigen::Vector2d(0.0, 0.0)), 1);
}

}  // namespace
}  // namespace millwear::wear
