#include "wear/evolve/surface_thinning.h"

#include <gtest/gtest.h>

namespace millwear::wear {
namespace {

/// Two fixed ends 10 mm apart and a node half-way, `up` above the line between them.
std::vector<SurfaceNode> bent(double up, double depth) {
  return {{{0.0, 0.0}, 0.0, true}, {{0.005, up}, depth, false}, {{0.01, 0.0}, 0.0, true}};
}

TEST(SurfaceThinning, DropsWhatLiesOnALine) {
  EXPECT_EQ(thinned(bent(0.5e-6, 1e-4), 1e-4).size(), 2U);
  EXPECT_EQ(thinned(bent(2e-6, 1e-4), 1e-4).size(), 3U);
}

// The node lies 0.5 um under the line and 0.2 um under the old surface: the line would add steel.
TEST(SurfaceThinning, NeverBringsSteelBack) {
  EXPECT_EQ(thinned(bent(-0.5e-6, 0.2e-6), 1e-4).size(), 3U);
  EXPECT_EQ(thinned(bent(-0.5e-6, 0.2e-6), 1e-2).size(), 3U);
  EXPECT_EQ(thinned(bent(-0.5e-6, 2e-6), 1e-4).size(), 2U);
}

TEST(SurfaceThinning, JoinsNodesThatAreClose) {
  EXPECT_EQ(thinned(bent(1e-3, 1e-4), 1e-2).size(), 2U);
  EXPECT_EQ(thinned(bent(1e-3, 1e-4), 1e-3).size(), 3U);
}

TEST(SurfaceThinning, KeepsFixedNodes) {
  auto surface = bent(0.0, 0.0);
  surface[1].fixed = true;
  EXPECT_EQ(thinned(surface, 1e-2).size(), 3U);
}

}  // namespace
}  // namespace millwear::wear
