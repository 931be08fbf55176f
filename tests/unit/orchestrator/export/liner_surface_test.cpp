#include "orchestrator/export/liner_surface.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "tests/support/sample_profiles.h"

namespace millwear::orchestrator {
namespace {

using wear::square_lifter;

constexpr double length = 0.25;

VtkPolyData surface_of(const LinerProfile& outline, LinerExtent extent, double mill_angle = 0.0) {
  std::vector<float> numbers;
  for (std::size_t i = 1; i < outline.nodes.size(); ++i) numbers.push_back(static_cast<float>(i));
  return liner_surface(outline, {{"number", 1, numbers}}, {extent, length, mill_angle});
}

Eigen::Vector3d point(const VtkPolyData& data, std::int32_t i) {
  const auto at = static_cast<std::size_t>(3 * i);
  return {data.points[at], data.points[at + 1], data.points[at + 2]};
}

/// Area times normal of a quadrilateral.
Eigen::Vector3d area_of(const VtkPolyData& data, std::size_t cell) {
  const auto* const corner = &data.polygons.connectivity[4 * cell];
  return 0.5 * (point(data, corner[2]) - point(data, corner[0]))
                   .cross(point(data, corner[3]) - point(data, corner[1]));
}

// The outline is 4 x 0.1 + 2 x 0.15 m and two pieces to the edges long.
TEST(LinerSurface, CutAtBinsHasEverySegmentInOne) {
  const LinerProfile liner = square_lifter();
  const LinerProfile outline = cut_at_bins(liner, 50);
  const double whole = arc_lengths(liner).back();
  const auto lengths = arc_lengths(outline);
  EXPECT_NEAR(lengths.back(), whole, 1e-12);
  const auto bins = bins_of_segments(outline, 50);
  ASSERT_EQ(bins.size(), outline.nodes.size() - 1);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    EXPECT_GE(lengths[i], whole * static_cast<double>(bins[i]) / 50 - 1e-7);
    EXPECT_LE(lengths[i + 1], whole * static_cast<double>(bins[i] + 1) / 50 + 1e-7);
  }
  EXPECT_EQ(std::set(bins.begin(), bins.end()).size(), 50U);
}

TEST(LinerSurface, CutAgainStaysAsItIs) {
  const LinerProfile outline = cut_at_bins(square_lifter(), 50);
  EXPECT_EQ(cut_at_bins(outline, 50).nodes.size(), outline.nodes.size());
}

TEST(LinerSurface, HasTheAreaOfTheProfileOnEveryLifter) {
  const LinerProfile outline = cut_at_bins(square_lifter(), 50);
  for (const auto extent : {LinerExtent::ring, LinerExtent::one_lifter}) {
    const VtkPolyData data = surface_of(outline, extent);
    double area = 0.0;
    for (std::size_t cell = 0; cell < data.polygons.offsets.size(); ++cell)
      area += area_of(data, cell).norm();
    const int lifters = extent == LinerExtent::ring ? 10 : 1;
    EXPECT_NEAR(area, lifters * length * arc_lengths(outline).back(), 1e-5);
    EXPECT_EQ(std::get<std::vector<float>>(data.cell_data[0].numbers).size(),
              data.polygons.offsets.size());
  }
}

// Each edge of a closed ring along the axis belongs to two quadrilaterals.
TEST(LinerSurface, OfARingIsClosed) {
  const LinerProfile outline = square_lifter();
  const VtkPolyData ring = surface_of(outline, LinerExtent::ring);
  EXPECT_EQ(ring.points.size() / 3, 2U * 10U * (outline.nodes.size() - 1));
  const VtkPolyData one = surface_of(outline, LinerExtent::one_lifter);
  EXPECT_EQ(one.points.size() / 3, 2U * outline.nodes.size());
  std::multiset<std::int32_t> uses(ring.polygons.connectivity.begin(),
                                   ring.polygons.connectivity.end());
  for (const auto corner : uses) ASSERT_EQ(uses.count(corner), 2U);
}

TEST(LinerSurface, FacesTheCharge) {
  const VtkPolyData data = surface_of(cut_at_bins(wear::bare_ring(), 50), LinerExtent::ring);
  for (std::size_t cell = 0; cell < data.polygons.offsets.size(); ++cell) {
    const Eigen::Vector3d outwards = point(data, data.polygons.connectivity[4 * cell]);
    EXPECT_LT(area_of(data, cell).dot(Eigen::Vector3d(outwards.x(), 0.0, outwards.z())), 0.0);
  }
}

// Along xi is from six o'clock to the side that rises, x < 0.
TEST(LinerSurface, TurnsAlongXi) {
  const LinerProfile ring{wear::sample_sector, {{-0.1, 0.0}, {0.0, 0.0}, {0.1, 0.0}}};
  const VtkPolyData at_rest = surface_of(ring, LinerExtent::one_lifter);
  EXPECT_NEAR(point(at_rest, 2).x(), 0.0, 1e-6);
  EXPECT_NEAR(point(at_rest, 2).z(), -1.0, 1e-6);
  EXPECT_NEAR(point(at_rest, 4).x(), -0.1, 1e-6);
  const VtkPolyData turned = surface_of(ring, LinerExtent::one_lifter, M_PI / 2.0);
  EXPECT_NEAR(point(turned, 2).x(), -1.0, 1e-6);
  EXPECT_NEAR(point(turned, 2).z(), 0.0, 1e-6);
  EXPECT_NEAR(point(turned, 3).y(), length, 1e-6);
}

}  // namespace
}  // namespace millwear::orchestrator
