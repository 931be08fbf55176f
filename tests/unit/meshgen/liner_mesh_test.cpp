#include "meshgen/liner_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "meshgen/facet_outline.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using test::degree;
using ::testing::HasSubstr;

Eigen::Vector3d centroid(const LinerMesh& mesh, std::size_t i) {
  const Triangle& t = mesh.triangles[i];
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

// Arithmetic on the triangle's number and geometry of its place must name the same lifter and
// facet.
TEST(LinerMesh, AddressAgreesWithGeometry) {
  constexpr double slice = 1.0;
  for (const auto& profile : {test::laboratory_liner(), test::production_liner()}) {
    const MeshSettings settings{.tolerance = 0.45e-3, .smallest_angle = 10.0 * degree};
    const LinerMesh mesh = build_liner_mesh(profile, slice, settings);
    ASSERT_GT(mesh.layers, 1);
    const auto outline = with_facets_below(dem_outline(profile, settings.tolerance),
                                           slice / mesh.layers / std::tan(settings.smallest_angle));
    ASSERT_EQ(mesh.facets_per_lifter, static_cast<int>(outline.size()) - 1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const TriangleAddress address = address_of(mesh, i);
      const Eigen::Vector3d place = centroid(mesh, i);
      const MasterPoint folded = to_master(profile.sector, place.x(), place.z(), 0.0);
      const Eigen::Vector2d along = outline[address.facet + 1] - outline[address.facet];
      const Eigen::Vector2d from_start = folded.position - outline[address.facet];
      const double share = from_start.dot(along) / along.squaredNorm();
      ASSERT_EQ(folded.row, address.lifter) << i;
      ASSERT_NEAR((from_start - share * along).norm(), 0.0, 1e-12) << i;
      ASSERT_TRUE(std::abs(share - 1.0 / 3.0) < 1e-6 || std::abs(share - 2.0 / 3.0) < 1e-6) << i;
      ASSERT_EQ(static_cast<int>(place.y() / slice * mesh.layers), address.layer) << i;
    }
  }
}

TEST(LinerMesh, SpansTheSliceToTheLastDigit) {
  const LinerMesh mesh = build_liner_mesh(test::laboratory_liner(), 0.12, {.tolerance = 0.45e-3});
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (mesh.layers == 1) {
      ASSERT_TRUE(vertex.y() == 0.0 || vertex.y() == 0.12) << vertex.y();
    }
  }
}

TEST(LinerMesh, FirstLifterStandsAtSixOClock) {
  const LinerMesh mesh = build_liner_mesh(test::laboratory_liner(), 0.12, {.tolerance = 0.45e-3});
  for (std::size_t i = 0; i < mesh.triangles.size() / static_cast<std::size_t>(mesh.rows); ++i) {
    EXPECT_LT(centroid(mesh, i).z(), -0.4);
  }
}

TEST(LinerMesh, NormalOfTheTopLooksAtTheAxis) {
  const LinerMesh mesh = build_liner_mesh(test::laboratory_liner(), 0.12, {.tolerance = 0.45e-3});
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Eigen::Vector3d b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const Eigen::Vector3d normal = a.cross(b).normalized();
    EXPECT_LT(Eigen::Vector2d(normal.x(), normal.z())
                  .dot(Eigen::Vector2d(mesh.vertices[t[0]].x(), mesh.vertices[t[0]].z())),
              0.0);
    EXPECT_NEAR(normal.y(), 0.0, 1e-12);
  }
}

// A facet of 1 mm in a slice of 100 mm: atan(1/100) = 0.573 degrees with one layer; 3 degrees take
// ceil(100 tan 3) = 6 layers of 16.7 mm, and no facet above 16.7 / tan 3 = 318 mm.
TEST(LinerMesh, AddsLayersForAShortFacet) {
  const auto profile = profile_of({0.52, 0.50, 12}, {0.040, 0.001, 20.0 * degree, 20.0 * degree});
  const LinerMesh mesh =
      build_liner_mesh(profile, 0.100, {.tolerance = 0.45e-3, .smallest_angle = 3.0 * degree});
  EXPECT_EQ(mesh.layers, 6);
}

TEST(LinerMesh, RefusesAFacetTooShortForTheSlice) {
  const auto profile = profile_of({0.52, 0.50, 12}, {0.040, 0.0001, 20.0 * degree, 20.0 * degree});
  try {
    static_cast<void>(build_liner_mesh(profile, 0.25, {.tolerance = 1e-6}));
    FAIL() << "a sliver was meshed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the shortest facet of the liner mesh is 0.0001 m"));
  }
}

// Half a micrometre is nothing that a drawing shows, two are.
TEST(LinerMesh, RefusesEndsThatDoNotMeetToAMicrometre) {
  auto profile = test::laboratory_liner();
  profile.nodes.back().y() += 5e-7;
  EXPECT_NO_THROW(static_cast<void>(build_liner_mesh(profile, 0.12, {.tolerance = 0.45e-3})));
  profile.nodes.back().y() += 1.5e-6;
  try {
    static_cast<void>(build_liner_mesh(profile, 0.12, {.tolerance = 0.45e-3}));
    FAIL() << "an open ring was meshed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("ends lie 2e-06 m apart"));
  }
}

TEST(LinerMesh, HonoursTheLongestFacet) {
  const MeshSettings settings{.tolerance = 0.45e-3, .longest_facet = 0.015};
  const LinerMesh mesh = build_liner_mesh(test::laboratory_liner(), 0.12, settings);
  for (const Triangle& t : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3d edge = mesh.vertices[t[corner]] - mesh.vertices[t[(corner + 1) % 3]];
      EXPECT_LE(std::hypot(edge.x(), edge.z()), 0.015 + 1e-12);
    }
  }
}

TEST(LinerMesh, AddressOfNoTriangleIsRefused) {
  const LinerMesh mesh = build_liner_mesh(test::laboratory_liner(), 0.12, {.tolerance = 0.45e-3});
  EXPECT_THROW(static_cast<void>(address_of(mesh, mesh.triangles.size())), std::logic_error);
}

}  // namespace
}  // namespace millwear::meshgen
