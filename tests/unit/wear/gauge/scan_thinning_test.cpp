#include "wear/gauge/scan_thinning.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mill/base/failure.h"
#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

using Curve = std::vector<Eigen::Vector2d>;

/// `count` points evenly along a line of 0.3 m, each 1 mm up or down in turn.
Curve ragged_line(int count) {
  Curve scan;
  for (int i = 0; i < count; ++i)
    scan.emplace_back(0.3 * i / (count - 1), i % 2 == 0 ? 1e-3 : -1e-3);
  return scan;
}

TEST(ScanThinning, FewPointsStayAsTheyAre) {
  const Curve nodes = square_lifter().nodes;
  EXPECT_EQ(thinned_scan(nodes, 1e-3, 1000), nodes);
  const Curve averaged = averaged_scan(nodes, 3e-3);
  ASSERT_EQ(averaged.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_LT((averaged[i] - nodes[i]).norm(), 1e-15);
}

// A drawing in small steps keeps its corners, and needs no other nodes.
TEST(ScanThinning, DenseDrawingKeepsItsCorners) {
  const Curve corners = {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}, {0.2, 0.1}};
  Curve dense;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    for (int k = 0; k < 1000; ++k)
      dense.emplace_back(corners[i] + k / 1000.0 * (corners[i + 1] - corners[i]));
  dense.push_back(corners.back());
  const Curve thinned = thinned_scan(dense, 1e-3, 1000);
  ASSERT_EQ(thinned.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    EXPECT_LT((thinned[i] - corners[i]).norm(), 1e-12);
}

// 50,000 points at 6 um: about a hundred means of some 500 each, on the line, from end to end.
TEST(ScanThinning, AveragesADenseScan) {
  const Curve scan = ragged_line(50000);
  const Curve averaged = thinned_scan(scan, 1e-3, 1000);
  EXPECT_NEAR(static_cast<double>(averaged.size()), 120.0, 35.0);
  for (std::size_t i = 1; i + 1 < averaged.size(); ++i) EXPECT_LT(std::abs(averaged[i].y()), 1e-5);
  for (std::size_t i = 1; i < averaged.size(); ++i) EXPECT_GT(averaged[i].x(), averaged[i - 1].x());
  EXPECT_NEAR(averaged.front().x(), 0.0, 1e-5);
  EXPECT_NEAR(averaged.back().x(), 0.3, 1e-5);
}

TEST(ScanThinning, RefusesPointsInNoOrder) {
  Curve cloud;
  for (int i = 0; i < 1000; ++i) cloud.emplace_back(0.3 * ((i * 617) % 1000) / 1000.0, 0.0);
  try {
    static_cast<void>(averaged_scan(cloud, 3e-3));
    FAIL();
  } catch (const InputError& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr("not in the order of the profile"));
  }
}

TEST(ScanThinning, RefusesAPoint) {
  EXPECT_THROW(static_cast<void>(averaged_scan(Curve(100, {0.1, 0.1}), 3e-3)), InputError);
}

}  // namespace
}  // namespace millwear::wear
